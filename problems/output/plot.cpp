#include "problems/output/plot.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "problems/output/picture_layout.hpp"

namespace rfm {
namespace {

void draw_marker(Canvas& canvas, const PixelPosition& at, double radius, const Colour& colour) {
  const PixelPosition point[] = {at};
  canvas.line(std::span(point), 2 * radius, colour);
}

void draw_curve(Canvas& canvas, const Axes& axes, const PlotCurve& curve, double scale) {
  for (const std::vector<PlotPoint>& part : curve.parts) {
    std::vector<PixelPosition> places;
    for (const PlotPoint& point : part) places.push_back(axes.place(point.x, point.y));
    if (places.size() > 1) canvas.line(places, curve.line_width * scale, curve.colour);
    if (curve.has_markers || places.size() == 1)
      for (const PixelPosition& place : places)
        draw_marker(canvas, place, 2.2 * curve.line_width * scale, curve.colour);
  }
}

void draw_labels(Canvas& canvas, const Axes& axes, const std::vector<PlotCurve>& curves,
                 bool is_outside) {
  struct Label {
    const PlotCurve* curve;
    PixelPosition at;
  };
  std::vector<Label> labels;
  for (const PlotCurve& curve : curves) {
    if (curve.label.empty() || curve.parts.empty() || curve.parts.back().empty()) continue;
    const PlotPoint& last = curve.parts.back().back();
    PixelPosition at = axes.place(last.x, last.y);
    if (is_outside) at.x = axes.frame.right();
    at.x += (curve.label_side == Align::before ? -0.8 : 0.8) * axes.font_size;
    at.y += curve.label_below * axes.font_size;
    labels.push_back({&curve, at});
  }
  if (is_outside) {  // one below the other
    std::ranges::sort(labels, {}, [](const Label& label) { return label.at.y; });
    for (std::size_t i = 1; i < labels.size(); ++i)
      labels[i].at.y = std::max(labels[i].at.y, labels[i - 1].at.y + 1.3 * axes.font_size);
  }
  for (const Label& label : labels)
    canvas.text(label.curve->label, label.at,
                {.size = axes.font_size,
                 .colour = label.curve->colour,
                 .horizontal = label.curve->label_side,
                 .halo = 2});
}

void draw_triangle(Canvas& canvas, const Axes& axes, const PlotTriangle& triangle) {
  const PixelPosition corner = axes.place(triangle.corner.x, triangle.corner.y),
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
  draw_labels(canvas, axes, plot.curves, plot.right_margin > 0);
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
  if (number < static_cast<int>(colours.size())) return colours[static_cast<std::size_t>(number)];
  // Hues a golden angle apart never come close to each other soon; lightness alternates.
  const double hue = 2.399963 * number, radius = number % 2 == 0 ? 0.42 : 0.3;
  const auto part = [&](double shift) { return radius * (1 + std::cos(hue + shift)); };
  return {part(0), part(2.0943951), part(4.1887902)};
}

}  // namespace rfm
