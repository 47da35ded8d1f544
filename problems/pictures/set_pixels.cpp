#include "problems/pictures/set_pixels.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/tape.hpp"

namespace rfm {
namespace {

double distance_from_segment(const PixelPosition& from, const PixelPosition& to, double x,
                             double y) {
  const double dx = to.x - from.x, dy = to.y - from.y, square = dx * dx + dy * dy;
  const double t =
      square > 0 ? std::clamp(((x - from.x) * dx + (y - from.y) * dy) / square, 0.0, 1.0) : 0.0;
  return std::hypot(x - from.x - t * dx, y - from.y - t * dy);
}

bool is_straight(const ThinSet& set) { return !set.points.empty() && set.bulge == 0; }

// Only the pixels around it are looked at: a chain has many segments.
void add_straight(const ThinSet& set, const PixelWindow& window, double reach,
                  std::vector<float>& distances) {
  const PixelPosition from = window.place(set.points.front()), to = window.place(set.points.back());
  const auto first = [&](double a, double b) {
    return std::max(0, static_cast<int>(std::floor(std::min(a, b) - reach)));
  };
  const auto last = [&](double a, double b, int count) {
    return std::min(count - 1, static_cast<int>(std::ceil(std::max(a, b) + reach)));
  };
  for (int y = first(from.y, to.y); y <= last(from.y, to.y, window.height); ++y)
    for (int x = first(from.x, to.x); x <= last(from.x, to.x, window.width); ++x) {
      const double distance = distance_from_segment(from, to, x + 0.5, y + 0.5);
      float& known = distances[static_cast<std::size_t>(y) * window.width + x];
      if (distance <= reach) known = std::min(known, static_cast<float>(distance));
    }
}

}  // namespace

std::vector<float> distances_from(const ThinSet& set, const PixelWindow& window, double reach) {
  std::vector<float> distances(static_cast<std::size_t>(window.pixel_count()),
                               std::numeric_limits<float>::infinity());
  for (const ThinSet& part : set.parts) add_straight(part, window, reach, distances);
  if (!set.parts.empty()) return distances;
  if (is_straight(set)) {
    add_straight(set, window, reach, distances);
    return distances;
  }
  const Tape function({set.function}, {0}, 2);
  for (int y = 0; y < window.height; ++y)
    for (int x = 0; x < window.width; ++x) {
      const double distance = function.value(window.centre(x, y)) / window.pixel_size;
      if (distance <= reach)
        distances[static_cast<std::size_t>(y) * window.width + x] = static_cast<float>(distance);
    }
  return distances;
}

}  // namespace rfm
