#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "core/field.hpp"
#include "core/field_source.hpp"
#include "core/line.hpp"
#include "core/quadric_evaluator.hpp"

namespace rfm {

class PointProgram;
class Tape;

/// A primitive as quadrature and branch-and-bound see it: values and gradients at single points,
/// rigorous bounds over boxes. Polynomials of degree ≤ 2 (half-planes, circles, ellipses, spheres,
/// cylinders, quadrics) are recognised in the expression and evaluated in closed form; all else
/// goes through a tape. Thread-safe; bounds of derivatives that vanish identically are exactly [0,
/// 0].
class LevelFunction {
 public:
  LevelFunction(const Field& field, int dimension);
  ~LevelFunction();
  LevelFunction(LevelFunction&&) noexcept;
  LevelFunction& operator=(LevelFunction&&) noexcept;

  int dimension() const { return dimension_; }
  double value(const Point& point) const {
    return quadric_ ? quadric_->value(point) : other_value(point);
  }
  /// The value; `slope` receives ∂/∂(axis).
  double value_and_slope(const Point& point, int axis, double& slope) const {
    if (!quadric_) return other_slope(point, axis, slope);
    slope = quadric_->slope(point, axis);
    return quadric_->value(point);
  }
  /// The value; `gradient` receives ∇ (zero beyond the dimension).
  double value_and_gradient(const Point& point, Point& gradient) const {
    if (!quadric_) return other_gradient(point, gradient);
    gradient = quadric_->gradient(point);
    return quadric_->value(point);
  }
  /// The value at the point `t` of a line; `slope` receives the derivative with respect to t.
  double value_and_slope(const Line& line, double t, double& slope) const;
  /// Bounds of value and slope along the part `range` of a line.
  LineBounds bounds(const Line& line, const Interval& range) const;
  /// What a quadric is along a line; nothing for other functions.
  std::optional<LinePolynomial> polynomial_along(const Line& line) const;
  /// Bounds of the value: fast, for classification.
  Interval value_bounds(const Box& box) const;
  /// Bounds of value and gradient, as tight as is available (Taylor-1; exact ranges of quadrics).
  FunctionBounds bounds(const Box& box) const;
  /// Coordinates where the function is not smooth along `axis` (knots of sampled fields).
  const std::vector<double>& breakpoints(int axis) const { return breakpoints_[axis]; }
  bool is_quadric() const { return quadric_.has_value(); }
  /// The function as a polynomial of degree ≤ 2; null for others.
  const QuadricEvaluator* quadric() const { return quadric_ ? &*quadric_ : nullptr; }
  /// What evaluates functions that are no quadrics; null for quadrics.
  const Tape* tape() const { return tape_.get(); }
  /// Bounds over all of space: [0, ∞) for a square.
  const Interval& range() const { return range_; }

 private:
  double other_value(const Point& point) const;
  double other_slope(const Point& point, int axis, double& slope) const;
  double other_gradient(const Point& point, Point& gradient) const;

  int dimension_;
  Interval range_;
  std::optional<QuadricEvaluator> quadric_;
  std::unique_ptr<const PointProgram> program_;
  std::unique_ptr<const Tape> tape_;
  std::array<std::vector<double>, 3> breakpoints_;
};

}  // namespace rfm
