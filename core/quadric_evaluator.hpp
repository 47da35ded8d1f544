#pragma once

#include "core/quadric.hpp"

namespace rfm {

/// A quadric made ready for millions of bounds: in plain arithmetic with one proven margin. Where
/// the margin leaves a sign open, as for faces on sides of the box, the intervals of `Quadric`
/// decide.
struct QuadricEvaluator : Quadric {
  explicit QuadricEvaluator(const Quadric& quadric) : Quadric(quadric) {}

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
