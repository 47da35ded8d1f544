#pragma once

#include <cmath>

#include "core/quadric.hpp"

namespace rfm {

/// A quadric made ready for millions of evaluations: values and slopes inline, bounds in plain
/// arithmetic with one proven margin. Where the margin leaves a sign open, as for faces on sides of
/// the box, the intervals of `Quadric` decide.
struct QuadricEvaluator : Quadric {
  explicit QuadricEvaluator(const Quadric& quadric) : Quadric(quadric) {}

  // Multiply-adds are written out, so that the value at a point is the same to the last bit
  // wherever this is inlined: boxes on both sides of a face must see the same sign.
  double value(const Point& point) const {
    const double x = point[0] - origin[0], y = point[1] - origin[1], z = point[2] - origin[2];
    const double p =
        std::fma(2, std::fma(square[1], y, square[2] * z), std::fma(square[0], x, linear[0]));
    const double q = std::fma(2 * square[4], z, std::fma(square[3], y, linear[1]));
    const double r = std::fma(square[5], z, linear[2]);
    return std::fma(x, p, std::fma(y, q, std::fma(z, r, constant)));
  }
  double slope(const Point& point, int axis) const {
    const double x = point[0] - origin[0], y = point[1] - origin[1], z = point[2] - origin[2];
    const double sum =
        std::fma(square[square_index(axis, 0)], x,
                 std::fma(square[square_index(axis, 1)], y, square[square_index(axis, 2)] * z));
    return std::fma(2, sum, linear[axis]);
  }
  Point gradient(const Point& x) const { return {slope(x, 0), slope(x, 1), slope(x, 2)}; }

  /// Rigorous bounds of value and gradient: the range, but for mixed terms, which are bounded one
  /// by one, and of second order in the size of the box with them.
  FunctionBounds bounds(const Box& box) const;
  Interval value_bounds(const Box& box) const;
  using Quadric::along;
  LineBounds bounds(const Line& line, const Interval& range) const {
    return Quadric::bounds(line, range);
  }
};

}  // namespace rfm
