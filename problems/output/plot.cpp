#include "problems/output/plot.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "problems/output/picture_layout.hpp"

namespace rfm {
namespace {

void draw_marker(Canvas& canvas, const Place2& at, double radius, const Colour& colour) {
  const Place2 point[] = {at};
  canvas.line(std::span(point), 2 * radius, colour);
}

void draw_curve(Canvas& canvas, const Axes& axes, const PlotCurve& curve, double scale) {
  for (const std::vector<PlotPoint>& part : curve.parts) {
    std::vector<Place2> places;
    for (const PlotPoint& point : part) places.push_back(axes.place(point.x, point.y));
    if (places.size() > 1) canvas.line(places, curve.line_width * scale, curve.colour);
    if (curve.has_markers || places.size() == 1)
      for (const Place2& place : places)
        draw_marker(canvas, place, 2.2 * curve.line_width * scale, curve.colour);
  }
  if (curve.label.empty() || curve.parts.empty() || curve.parts.back().empty()) return;
  const PlotPoint& last = curve.parts.back().back();
  const Place2 at = axes.place(last.x, last.y);
  canvas.text(curve.label, {at.x + 0.8 * axes.font_size, at.y},
              {.size = axes.font_size, .colour = curve.colour, .halo = 2});
}

void draw_triangle(Canvas& canvas, const Axes& axes, const PlotTriangle& triangle) {
  const Place2 corner = axes.place(triangle.corner.x, triangle.corner.y),
               along_x = axes.place(triangle.along_x.x, triangle.along_x.y),
               along_y = axes.place(triangle.along_y.x, triangle.along_y.y);
  const Colour grey{0.4, 0.4, 0.4};
  canvas.fill({corner, along_x, along_y}, {0.92, 0.92, 0.92});
  canvas.line({corner, along_x, along_y, corner}, 1, grey);
  const bool is_left = corner.x < along_x.x;
  canvas.text(triangle.label,
              {corner.x + (is_left ? -0.4 : 0.4) * axes.font_size, 0.5 * (corner.y + along_y.y)},
              {.size = 0.9 * axes.font_size,
               .colour = grey,
               .horizontal = is_left ? Align::before : Align::after,
               .halo = 2});
}

// Whatever was painted beyond the frame, but not the frame itself, becomes white again.
void clear_around(Canvas& canvas, const PixelRectangle& frame) {
  const double width = canvas.width(), height = canvas.height();
  canvas.fill({{0, 0}, {width, 0}, {width, frame.top - 1}, {0, frame.top - 1}}, white);
  canvas.fill({{0, frame.bottom() + 1}, {width, frame.bottom() + 1}, {width, height}, {0, height}},
              white);
}

}  // namespace

Image draw_plot(const Plot& plot) {
  PictureRequest request;
  request.width = plot.width;
  request.title = plot.title;
  request.aspect = plot.aspect;
  const double font = label_size(plot.width);
  request.left_margin = left_margin(plot.y, font);
  request.bottom_margin = bottom_margin(plot.x, font);
  request.right_margin = plot.right_margin;
  const PictureLayout layout = picture_layout(request);
  Canvas canvas(layout.width, layout.height);
  const Axes axes{layout.shown, plot.x, plot.y, font};
  axes.draw_grid(canvas);
  for (const PlotTriangle& triangle : plot.triangles) draw_triangle(canvas, axes, triangle);
  for (const PlotCurve& curve : plot.curves) draw_curve(canvas, axes, curve, font / 16);
  clear_around(canvas, layout.shown);
  axes.draw(canvas);
  draw_frame(canvas, layout, request);
  return canvas.image();
}

Colour distinct_colour(int number) {
  // Okabe and Ito (2008), darkened where they are too light for lines on white.
  static constexpr std::array<Colour, 8> colours = {{{0.00, 0.45, 0.70},
                                                     {0.84, 0.37, 0.00},
                                                     {0.00, 0.55, 0.40},
                                                     {0.72, 0.40, 0.60},
                                                     {0.80, 0.56, 0.00},
                                                     {0.25, 0.62, 0.85},
                                                     {0.45, 0.25, 0.60},
                                                     {0.55, 0.30, 0.15}}};
  return colours[static_cast<std::size_t>(number) % colours.size()];
}

}  // namespace rfm
