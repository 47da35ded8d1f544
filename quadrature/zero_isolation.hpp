#pragma once

#include <span>
#include <vector>

#include "core/level_function.hpp"

namespace rfm {

struct ZeroSearchOptions {
  /// Boxes are not halved below this part of the longest side: what is left there is unresolved.
  /// Two curves that touch leave about 1/√smallest boxes.
  double smallest = 0x1p-14;
  /// The search is given up after as many boxes, as where two functions vanish on the same curve.
  int max_unresolved = 2000;
};

/// The common zeros of n functions in n coordinates.
struct ZeroSet {
  /// Simple zeros, each proved to exist.
  std::vector<Point> zeros;
  /// Boxes that may hold further zeros, which are not simple (or nearly so); none elsewhere.
  std::vector<Box> unresolved;
};

/// All common zeros of `functions` in the closed `box` as functions of the coordinates `axes`, as
/// many as there are functions; along the other axes the box must have no length. Every zero is
/// right to rounding.
///
/// Method: branch and bound with the operator of Krawczyk (1969; see A. Neumaier, Interval Methods
/// for Systems of Equations, 1990, section 5.1). With Y the inverse of the Jacobian at the centre,
/// ‖I − Y J‖ < 1 for all Jacobians J over a box proves that it holds at most one zero, which
/// Newton's method finds or finds to be elsewhere; ‖Y F(p)‖ + ‖I − Y J‖ r ≤ r on a small box around
/// p proves that one exists.
ZeroSet isolate_zeros(std::span<const LevelFunction* const> functions, const Box& box,
                      std::span<const int> axes, const ZeroSearchOptions& options = {});

/// Newton's method from `start` for the same system, without proofs: false if it does not converge
/// to rounding within `reach` of the start.
bool newton_zero(std::span<const LevelFunction* const> functions, std::span<const int> axes,
                 double reach, Point& point);

}  // namespace rfm
