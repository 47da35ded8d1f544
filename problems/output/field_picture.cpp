#include "problems/output/field_picture.hpp"

#include <algorithm>
#include <cmath>

namespace rfm {
namespace {

// How dark the contour line nearest to a value is at a pixel.
double contour_amount(double value, double slope, const FieldStyle& style) {
  if (style.level_step <= 0 || !std::isfinite(value) || !(slope > 1e-4 * style.level_step))
    return 0;
  const double level =
      style.first_level +
      style.level_step * std::round((value - style.first_level) / style.level_step);
  // A level at the very end of the range is no line but the boundary or an extremum.
  const double margin = 1e-9 * (style.scale.high() - style.scale.low());
  if (level <= style.scale.low() + margin || level >= style.scale.high() - margin) return 0;
  const double distance = std::abs(value - level) / slope;
  const double covered =
      std::clamp(0.5 * (style.line_width + 1) - distance, 0.0, std::min(1.0, style.line_width));
  const double spacing = style.level_step / slope;
  return 0.65 * covered * std::clamp((spacing - 2) / 2, 0.0, 1.0);
}

struct FieldArrow {
  int x, y;  // its middle, a pixel of the window
  double along_x, along_y;
  double length;
};

// On a regular pattern, where the field has a value.
std::vector<FieldArrow> collect_arrows(const FieldPicture& picture, int step) {
  const PixelWindow& window = picture.window;
  std::vector<FieldArrow> arrows;
  for (int y = (window.height % step + step) / 2; y < window.height; y += step)
    for (int x = (window.width % step + step) / 2; x < window.width; x += step) {
      const std::size_t pixel = static_cast<std::size_t>(y) * window.width + x;
      const double vx = picture.vector_x[pixel], vy = picture.vector_y[pixel];
      if (picture.region.distance[pixel] >= 0 && std::isfinite(vx) && std::isfinite(vy))
        arrows.push_back({x, y, vx, vy, std::hypot(vx, vy)});
    }
  return arrows;
}

// The length that all but one of twenty arrows stay below: a singularity is not to make the others
// vanish.
double typical_length(const std::vector<FieldArrow>& arrows) {
  std::vector<double> lengths;
  for (const FieldArrow& arrow : arrows) lengths.push_back(arrow.length);
  const auto place =
      lengths.begin() + static_cast<std::ptrdiff_t>(0.95 * (lengths.size() - 1) + 0.5);
  std::nth_element(lengths.begin(), place, lengths.end());
  return *place;
}

void paint_arrows(Canvas& canvas, int left, int top, const FieldPicture& picture,
                  const FieldStyle& style) {
  const PixelWindow& window = picture.window;
  const int step = std::max(8, static_cast<int>(style.arrow_spacing));
  const std::vector<FieldArrow> arrows = collect_arrows(picture, step);
  const double typical = arrows.empty() ? 0 : typical_length(arrows);
  if (!(typical > 0)) return;
  const auto is_inside = [&](double x, double y) {
    const int column = static_cast<int>(std::floor(x)), row = static_cast<int>(std::floor(y));
    return column >= 0 && row >= 0 && column < window.width && row < window.height &&
           picture.region.distance[static_cast<std::size_t>(row) * window.width + column] >= 0;
  };
  for (const FieldArrow& arrow : arrows) {
    const double drawn = std::min(arrow.length / typical, 1.0) * step;
    if (drawn < 0.12 * step) continue;  // too short to have a direction
    const double ex = 0.5 * drawn * arrow.along_x / arrow.length,
                 ey = -0.5 * drawn * arrow.along_y / arrow.length;
    const double x = arrow.x + 0.5, y = arrow.y + 0.5;
    if (!is_inside(x - ex, y - ey) || !is_inside(x + ex, y + ey)) continue;
    const std::size_t pixel = static_cast<std::size_t>(arrow.y) * window.width + arrow.x;
    const Colour colour = lightness(style.scale(picture.value[pixel])) < 0.62 ? white : black;
    canvas.arrow({left + x - ex, top + y - ey}, {left + x + ex, top + y + ey},
                 std::clamp(step / 20.0, 1.0, 4.0), colour);
  }
}

}  // namespace

std::optional<ValueRange> range_of(const FieldPicture& picture) {
  ValueRange range{INFINITY, -INFINITY};
  for (std::size_t i = 0; i < picture.value.size(); ++i) {
    if (picture.region.distance[i] < 0 || !std::isfinite(picture.value[i])) continue;
    range.low = std::min(range.low, picture.value[i]);
    range.high = std::max(range.high, picture.value[i]);
  }
  if (range.low > range.high) return std::nullopt;
  return range;
}

void paint_field(Canvas& canvas, int left, int top, const FieldPicture& picture,
                 const FieldStyle& style) {
  Image& image = canvas.image();
  const PixelWindow& window = picture.window;
  for (int y = 0; y < window.height; ++y)
    for (int x = 0; x < window.width; ++x) {
      const std::size_t pixel = static_cast<std::size_t>(y) * window.width + x;
      const double inside = picture.region.covered(pixel),
                   edge = picture.region.on_line(pixel, style.boundary_width);
      if ((inside <= 0 && edge <= 0) || !image.contains(left + x, top + y)) continue;
      Colour colour = image.pixel(left + x, top + y);
      if (inside > 0) {
        Colour shown = style.scale(picture.value[pixel]);
        if (!picture.slope.empty())
          shown = mixed(shown, black,
                        contour_amount(picture.value[pixel], picture.slope[pixel], style));
        for (const RegionPixels& part : picture.parts)
          shown = mixed(shown, black, 0.5 * part.on_line(pixel, style.line_width));
        colour = mixed(colour, shown, inside);
      }
      image.set_pixel(left + x, top + y, mixed(colour, black, edge));
    }
  if (!picture.vector_x.empty()) paint_arrows(canvas, left, top, picture, style);
}

}  // namespace rfm
