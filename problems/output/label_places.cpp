#include "problems/output/label_places.hpp"

#include <algorithm>
#include <cmath>

namespace rfm {

LabelPlaces::LabelPlaces(int width, int height)
    : width_(width),
      height_(height),
      columns_((width + side - 1) / side),
      rows_((height + side - 1) / side),
      squares_(static_cast<std::size_t>(columns_) * rows_) {}

int LabelPlaces::square_of(double x, double y) const {
  const int column = std::clamp(static_cast<int>(x) / side, 0, columns_ - 1),
            row = std::clamp(static_cast<int>(y) / side, 0, rows_ - 1);
  return row * columns_ + column;
}

void LabelPlaces::add_curve_pixel(int curve, int x, int y) {
  std::vector<int>& known = squares_[square_of(x, y)].curves;
  if (std::ranges::find(known, curve) == known.end()) known.push_back(curve);
  if (curve >= static_cast<int>(curves_.size())) curves_.resize(curve + 1);
  curves_[curve].push_back({x + 0.5, y + 0.5});
}

void LabelPlaces::add_painted_pixel(int x, int y) { ++squares_[square_of(x, y)].painted_pixels; }

double LabelPlaces::penalty(int curve, const PixelRectangle& text) const {
  if (text.left < 1 || text.top < 1 || text.right() > width_ - 1 || text.bottom() > height_ - 1)
    return INFINITY;
  double painted = 0, within = 0, nearest = INFINITY;  // the nearest of the other curves
  const double away = text.height;
  for (double y = text.top - away; y < text.bottom() + away; y += side)
    for (double x = text.left - away; x < text.right() + away; x += side) {
      if (x < 0 || y < 0 || x >= width_ || y >= height_) continue;
      const Square& square = squares_[square_of(x, y)];
      const double dx = std::max({text.left - x, x - text.right(), 0.0}),
                   dy = std::max({text.top - y, y - text.bottom(), 0.0});
      const double distance = std::hypot(dx, dy);
      const bool is_within = distance < side;
      if (is_within && (square.is_taken || !square.curves.empty())) return INFINITY;
      if (is_within) painted += square.painted_pixels / double(side * side);
      if (is_within) ++within;
      for (const int other : square.curves)
        if (other != curve) nearest = std::min(nearest, distance);
    }
  // Other curves are to keep away by about the height of the text, so that the name is not theirs.
  return 6 * painted / std::max(1.0, within) + 40 * std::max(0.0, 1 - nearest / away);
}

std::optional<PixelPosition> LabelPlaces::place(int curve, const TextExtent& text) {
  if (curve >= static_cast<int>(curves_.size()) || curves_[curve].empty()) return std::nullopt;
  const std::vector<PixelPosition>& pixels = curves_[curve];
  const double width = text.width, height = text.height, gap = 0.35 * height;
  PixelPosition middle;
  for (const PixelPosition& pixel : pixels) {
    middle.x += pixel.x / static_cast<double>(pixels.size());
    middle.y += pixel.y / static_cast<double>(pixels.size());
  }
  double reach = 0;
  for (const PixelPosition& pixel : pixels)
    reach = std::max(reach, std::hypot(pixel.x - middle.x, pixel.y - middle.y));
  constexpr std::size_t tried = 160;
  const std::size_t step = std::max<std::size_t>(1, pixels.size() / tried);
  double least = INFINITY;
  PixelRectangle best;
  for (std::size_t i = step / 2; i < pixels.size(); i += step)
    for (const int dx : {-1, 0, 1})
      for (const int dy : {-1, 0, 1}) {
        if (dx == 0 && dy == 0) continue;
        const double centre_x = pixels[i].x + dx * (0.5 * width + gap),
                     centre_y = pixels[i].y + dy * (0.5 * height + gap);
        const PixelRectangle rectangle{centre_x - 0.5 * width, centre_y - 0.5 * height, width,
                                       height};
        // Beside or above and below reads better than across a corner, the middle better than an
        // end.
        const double off_middle =
            std::hypot(pixels[i].x - middle.x, pixels[i].y - middle.y) / (1 + reach);
        const double value =
            penalty(curve, rectangle) + (dx != 0 && dy != 0 ? 4 : 0) + 3 * off_middle;
        if (value < least) {
          least = value;
          best = rectangle;
        }
      }
  if (!std::isfinite(least)) return std::nullopt;
  for (double y = best.top; y < best.bottom() + side; y += side)
    for (double x = best.left; x < best.right() + side; x += side)
      squares_[square_of(x, y)].is_taken = true;
  return PixelPosition{best.left, best.top};
}

}  // namespace rfm
