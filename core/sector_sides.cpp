#include "core/sector_sides.hpp"

#include <cmath>
#include <numbers>

#include "core/primitives.hpp"

namespace rfm {
namespace {

bool is_half_turn(double from, double to) {
  return std::fabs(to - from - std::numbers::pi) <= 1e-12 * (1 + std::fabs(from));
}

}  // namespace

std::optional<Region> straight_side(const Point& center, double from, double to) {
  if (!is_half_turn(from, to)) return std::nullopt;
  return half_plane(center, {-std::sin(from), std::cos(from)}).named("from_line");
}

std::vector<OutlineSide> sector_sides(const Point& center, double from, double to) {
  if (!is_half_turn(from, to)) return {};
  const Field along =
      std::cos(from) * (x_coordinate() - center[0]) + std::sin(from) * (y_coordinate() - center[1]);
  return {{"from", {"from_line"}, along}, {"to", {"from_line"}, -along}};
}

}  // namespace rfm
