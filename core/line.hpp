#pragma once

#include <algorithm>

#include "core/box.hpp"

namespace rfm {

/// The straight line of the points origin + t · direction; the direction need not have length 1.
struct Line {
  Point origin{};
  Point direction{};

  Point at(double t) const {
    return {origin[0] + t * direction[0], origin[1] + t * direction[1],
            origin[2] + t * direction[2]};
  }
  /// Encloses coordinate `axis` where the parameter lies in `t`.
  Interval coordinate(int axis, const Interval& t) const {
    return Interval(origin[axis]) + Interval(direction[axis]) * t;
  }
};

/// Bounds of a function and of its derivative along a part of a line. `smooth` is false where the
/// function may fail to be differentiable somewhere there.
struct LineBounds {
  Interval value;
  Interval slope;
  bool smooth = true;
};

/// c₀ + c₁ t + c₂ t²: a polynomial of degree two along a line.
struct LinePolynomial {
  double constant = 0, linear = 0, square = 0;

  double value(double t) const { return constant + t * (linear + t * square); }
};

}  // namespace rfm
