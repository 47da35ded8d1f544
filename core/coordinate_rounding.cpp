#include "core/coordinate_rounding.hpp"

#include <algorithm>
#include <cmath>

namespace rfm {
namespace {

template <typename Condition>
bool every_coordinate(std::span<const Point> points, Condition condition) {
  return std::ranges::all_of(points,
                             [&](const Point& p) { return condition(p[0]) && condition(p[1]); });
}

}  // namespace

double coordinate_rounding(std::span<const Point> points) {
  double largest = 0;
  for (const Point& p : points) largest = std::max({largest, std::fabs(p[0]), std::fabs(p[1])});
  if (largest == 0) return 0;
  const double finest = 0x1p-52 * largest;
  const auto is_multiple_of = [](double unit) {
    return [=](double x) {
      const double ratio = x / unit;
      return std::fabs(ratio - std::round(ratio)) <= 0x1p-50 * std::fabs(ratio);
    };
  };
  // From 10ᵏ > largest: the nearest doubles of decimal numbers are multiples up to their rounding.
  int exponent = static_cast<int>(std::floor(std::log10(largest))) + 1;
  double unit = std::pow(10.0, exponent);
  while (unit > finest && !every_coordinate(points, is_multiple_of(unit)))
    unit = std::pow(10.0, --exponent);
  unit = std::max(unit, finest);
  const auto is_single = [&](double x) {
    return std::fabs(x - static_cast<double>(static_cast<float>(x))) <= 0.51 * unit;
  };
  const double single = 0x1p-24 * largest;
  return unit < single && every_coordinate(points, is_single) ? single : unit;
}

}  // namespace rfm
