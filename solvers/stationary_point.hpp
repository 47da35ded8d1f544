#pragma once

#include <optional>
#include <span>
#include <vector>

#include "core/field.hpp"
#include "core/tape.hpp"

namespace rfm {

/// Stationary points of a function on the common zero set of some of a list of constraints: inside
/// a body, on its faces, along its edges and at its corners.
///
///     StationaryPoints points(f, {plane.level, sphere.level}, 3);
///     const int edge[] = {0, 1};
///     const auto place = points.find(edge, start, reach);
class StationaryPoints {
 public:
  /// Compiles f and the constraints with derivatives up to order 2.
  StationaryPoints(const Field& f, const std::vector<Field>& constraints, int dimension);

  /// Newton's method on the conditions of Lagrange, ∇f = Σ λ_k ∇g_k and g_k = 0 for the k in
  /// `active`, from `start` with the multipliers of least squares: of second order where the
  /// conditions are regular, and with the shortest step where they are not, as for a function that
  /// is constant along an edge. Empty if it leaves the ball of radius `reach` around `start`, meets
  /// values that are not finite, or does not converge to the noise of its derivatives.
  std::optional<Point> find(std::span<const int> active, const Point& start, double reach);
  /// f, and constraint k, at a point.
  double value(const Point& point) const { return tape_.value(point); }
  double constraint(int k, const Point& point) const { return tape_.value(point, 1 + k); }

 private:
  void evaluate(const Point& point);
  /// Back to the zeros of the active constraints after a step along their tangents: f may be
  /// undefined beyond them, as a solution is beyond its grid.
  void project(std::span<const int> active, Point& point);

  int dimension_;
  Tape tape_;
  Tape::Workspace workspace_;
};

}  // namespace rfm
