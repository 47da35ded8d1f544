#include "quadrature/ray_crossings.hpp"

#include "quadrature/root_isolation.hpp"

namespace rfm {
namespace {

// Signs follow from where the zeros are, not from values: the parts of a ray then fit together
// whatever is rounded, also where a part begins at a zero.
void cross_polynomial(const LinePolynomial& polynomial, double low, double high,
                      RayCrossings& crossings) {
  const auto [c, b, a] = polynomial;
  double zeros[2];
  int count = 0;
  bool positive = c >= 0;  // before the first zero
  if (a == 0) {
    if (b != 0) {
      positive = b < 0;
      zeros[count++] = -c / b;
    }
  } else {
    positive = a > 0;
    const double discriminant = b * b - 4 * a * c;
    if (discriminant > 0) {
      // The stable pair: no difference of nearly equal numbers.
      const double q = -0.5 * (b + std::copysign(std::sqrt(discriminant), b));
      const double first = q / a, second = c / q;
      zeros[count++] = std::min(first, second);
      zeros[count++] = std::max(first, second);
    }
  }
  for (int i = 0; i < count; ++i) {
    if (zeros[i] <= low)
      positive = !positive;
    else if (zeros[i] <= high)
      crossings.positions.push_back(zeros[i]);
  }
  crossings.starts_positive = positive;
}

void cross_monotone(const LevelFunction& level, const Line& line, double low, double high,
                    RayCrossings& crossings) {
  const auto function = [&](double t, double& slope) {
    return level.value_and_slope(line, t, slope);
  };
  const double value_low = level.value(line.at(low)), value_high = level.value(line.at(high));
  crossings.starts_positive = value_low >= 0;
  if (crossings.starts_positive != (value_high >= 0))
    crossings.positions.push_back(bracketed_root(function, low, high, value_low, value_high));
}

void cross_function(const LevelFunction& level, const Line& line, double low, double high,
                    RayCrossings& crossings) {
  const LineBounds whole = level.bounds(line, {low, high});
  if (whole.value.low >= 0 || whole.value.high < 0) {
    crossings.starts_positive = whole.value.low >= 0;
    return;
  }
  const auto function = [&](double t, double& slope) {
    return level.value_and_slope(line, t, slope);
  };
  const auto slope_bounds = [&](double from, double to) {
    if (from == low && to == high) return whole.slope;
    const LineBounds part = level.bounds(line, {from, to});
    // A part where the sign is known holds no zero, as if the function were monotone there.
    return part.value.excludes_zero() ? Interval(1) : part.slope;
  };
  // Zeros and contacts cut the line into parts of one sign each, which any point inside tells.
  std::vector<double>& places = crossings.positions;
  IsolationBudget budget;
  isolate_roots(
      function, slope_bounds, low, high, 0.0, [&](double root) { places.push_back(root); }, budget);
  std::ranges::sort(places);
  double slope = 0;
  bool positive = false;
  std::size_t kept = 0;
  for (std::size_t i = 0; i <= places.size(); ++i) {
    const double from = i == 0 ? low : places[i - 1], to = i == places.size() ? high : places[i];
    const bool next = function(0.5 * (from + to), slope) >= 0;
    if (i == 0)
      crossings.starts_positive = next;
    else if (next != positive)
      places[kept++] = places[i - 1];
    positive = next;
  }
  places.resize(kept);
}

}  // namespace

void find_crossings(const LevelFunction& level,
                    const std::array<Interval, maximum_variables>& gradient, const Line& line,
                    double low, double high, RayCrossings& crossings) {
  crossings.positions.clear();
  if (const auto polynomial = level.polynomial_along(line))
    return cross_polynomial(*polynomial, low, high, crossings);
  Interval slope;
  for (int axis = 0; axis < level.dimension(); ++axis)
    slope = slope + gradient[axis] * Interval(line.direction[axis]);
  if (slope.excludes_zero())
    cross_monotone(level, line, low, high, crossings);
  else
    cross_function(level, line, low, high, crossings);
}

}  // namespace rfm
