#include "core/ellipsoid_distance.hpp"

#include <cmath>
#include <limits>

#include "core/dynamic_jet.hpp"
#include "core/error.hpp"
#include "core/jet_functions.hpp"

namespace rfm {

EllipsoidDistance::EllipsoidDistance(const Point& radii, int dimension) : dimension_(dimension) {
  if (dimension < 2 || dimension > 3)
    throw InvalidArgument("ellipsoids lie in 2 or 3 dimensions, not in " +
                          std::to_string(dimension));
  for (int axis = 0; axis < dimension; ++axis) {
    if (!(radii[axis] > 0)) throw InvalidArgument("the radii of an ellipsoid must be positive");
    radii_[axis] = radii[axis];
    squares_[axis] = radii[axis] * radii[axis];
    if (radii_[axis] < radii_[thinnest_]) thinnest_ = axis;
  }
}

EllipsoidDistance::Root EllipsoidDistance::root(const Point& point) const {
  const double least = -squares_[thinnest_];
  double t = least;
  for (int axis = 0; axis < dimension_; ++axis)
    t = std::max(t, radii_[axis] * std::fabs(point[axis]) - squares_[axis]);
  // Σ (a x / (t + a²))² − 1 falls and is convex: steps from its left never pass the root.
  constexpr int most_steps = 200;
  for (int step = 0; step < most_steps; ++step) {
    double value = -1, slope = 0;
    for (int axis = 0; axis < dimension_; ++axis) {
      if (point[axis] == 0) continue;
      const double shifted = t + squares_[axis];
      const double part = radii_[axis] * point[axis] / shifted;
      value += part * part;
      slope -= 2 * part * part / shifted;
    }
    if (value <= 0) return {t, t <= least};
    const double next = t - value / slope;
    if (!(next > t)) break;
    t = next;
  }
  return {t, false};
}

double EllipsoidDistance::distance(const Point& point, const Root& root) const {
  if (root.on_focal) {
    // The foot beside the focal set: on the thinnest axis it is as far out as the ellipsoid is.
    double left = 1, square = 0;
    for (int axis = 0; axis < dimension_; ++axis) {
      const double width = squares_[axis] - squares_[thinnest_];
      if (axis == thinnest_ || width == 0) continue;
      const double foot = squares_[axis] * point[axis] / width;
      left -= foot * foot / squares_[axis];
      square += (foot - point[axis]) * (foot - point[axis]);
    }
    return std::sqrt(square + squares_[thinnest_] * std::max(0.0, left));
  }
  double square = 0;
  for (int axis = 0; axis < dimension_; ++axis) {
    const double part = point[axis] / (root.t + squares_[axis]);
    if (point[axis] != 0) square += part * part;
  }
  return -root.t * std::sqrt(square);
}

void EllipsoidDistance::evaluate(const std::array<const double*, 3>& coordinates, int count,
                                 int variables, int order, double* jets, int stride) const {
  using Number = DynamicJet<double>;
  const JetShape& shape = JetShape::get(variables, order);
  for (int i = 0; i < count; ++i) {
    Point point{};
    for (int axis = 0; axis < dimension_; ++axis) point[axis] = coordinates[axis][i];
    const Root found = root(point);
    for (int c = 0; c < shape.size(); ++c) jets[std::ptrdiff_t(c) * stride + i] = 0;
    jets[i] = distance(point, found);
    if (found.on_focal || order == 0) continue;
    std::array<Number, 3> x;
    for (int axis = 0; axis < dimension_; ++axis)
      x[axis] = axis < variables ? Number::variable(shape, axis, point[axis]) : Number(point[axis]);
    Number t(shape);
    t.c[0] = found.t;
    for (int right = 1; right <= order; right *= 2) {
      Number value(-1.0), slope(0.0);
      for (int axis = 0; axis < dimension_; ++axis) {
        const Number shifted = t + Number(squares_[axis]);
        const Number part = Number(radii_[axis]) * x[axis] / shifted;
        value = value + part * part;
        slope = slope - Number(2.0) * part * part / shifted;
      }
      t = t - value / slope;
    }
    Number square(0.0);
    for (int axis = 0; axis < dimension_; ++axis) {
      const Number part = x[axis] / (t + Number(squares_[axis]));
      square = square + part * part;
    }
    const Number result = -(t * sqrt(square));
    for (int c = 1; c < shape.size(); ++c)
      jets[std::ptrdiff_t(c) * stride + i] = coefficient(result, c);
  }
}

std::array<Interval, maximum_variables> EllipsoidDistance::gradient(const Box& box,
                                                                    bool& smooth) const {
  std::array<Interval, maximum_variables> gradient{};
  for (int axis = 0; axis < dimension_; ++axis) gradient[axis] = Interval(-1, 1);
  Point least{}, most{};
  for (int axis = 0; axis < dimension_; ++axis) {
    const Interval size = abs(box.interval(axis));
    least[axis] = size.low;
    most[axis] = size.high;
  }
  const Root lowest = root(least);
  // Roundings of t, relative to the squares it is added to.
  constexpr double rounding = 1e-12;
  const double margin = rounding * (squares_[0] + squares_[1] + squares_[2] + std::fabs(lowest.t));
  smooth = !lowest.on_focal && lowest.t - margin > -squares_[thinnest_];
  if (!smooth) return gradient;
  const double highest = root(most).t;
  const Interval t(lowest.t - margin, highest + rounding * std::fabs(highest) + margin);
  std::array<Interval, 3> p{};
  for (int axis = 0; axis < dimension_; ++axis)
    p[axis] = box.interval(axis) / (t + Interval(squares_[axis]));
  for (int axis = 0; axis < dimension_; ++axis) {
    Interval others(0);
    for (int other = 0; other < dimension_; ++other)
      if (other != axis) others = others + square(p[other]);
    // p / √(p² + q) grows with p, and its size falls with q.
    const auto slope = [&](double own, bool up) {
      const double q = (own > 0) == up ? others.low : others.high;
      return own == 0 ? 0.0 : own / std::sqrt(own * own + std::max(0.0, q));
    };
    gradient[axis] = Interval(std::max(-1.0, -slope(p[axis].high, true) - rounding),
                              std::min(1.0, -slope(p[axis].low, false) + rounding));
  }
  return gradient;
}

FunctionBounds EllipsoidDistance::bounds(const Box& box) const {
  const Point center = box.center();
  FunctionBounds bounds;
  for (int axis = 0; axis < dimension_; ++axis) bounds.gradient[axis] = Interval(-1, 1);
  bounds.smooth = false;
  Point half{};
  bool finite = true;
  for (int axis = 0; axis < dimension_; ++axis) {
    half[axis] = std::max(box.high[axis] - center[axis], center[axis] - box.low[axis]);
    finite = finite && std::isfinite(half[axis]);
  }
  if (!finite) {
    bounds.value = Interval(-std::numeric_limits<double>::infinity(), radii_[thinnest_]);
    return bounds;
  }
  bounds.gradient = gradient(box, bounds.smooth);
  double change = 0, square = 0, rounding = 0;
  for (int axis = 0; axis < dimension_; ++axis) {
    const Interval& slope = bounds.gradient[axis];
    change += std::max(std::fabs(slope.low), std::fabs(slope.high)) * half[axis];
    square += half[axis] * half[axis];
    rounding += radii_[axis] + half[axis];
  }
  const double value = distance(center, root(center));
  const double reach = std::min(change, std::sqrt(square)) + 1e-13 * (std::fabs(value) + rounding);
  bounds.value = Interval(value - reach, value + reach);
  return bounds;
}

std::vector<double> EllipsoidDistance::breakpoints(int) const { return {}; }

Box EllipsoidDistance::valid() const {
  constexpr double infinite = std::numeric_limits<double>::infinity();
  return {dimension_, {-infinite, -infinite, -infinite}, {infinite, infinite, infinite}};
}

}  // namespace rfm
