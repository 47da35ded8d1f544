#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "core/box.hpp"
#include "core/field.hpp"
#include "core/quadric_evaluator.hpp"

namespace rfm {

/// An expression for value and gradient at single points, as roots are sought, and for their bounds
/// over boxes: the same rules as a tape's, for the operations that shapes are mostly made of,
/// without what a tape carries along for blocks and orders; polynomials of degree ≤ 2 within the
/// expression are one step. Value and three slopes are one vector of four numbers; along one axis
/// they are two numbers; bounds are Taylor models of first order. Immutable.
class PointProgram {
 public:
  /// Nothing for expressions with other operations, other coordinates than x, y, z, or too many
  /// operations.
  static std::optional<PointProgram> compiled(const Field& field, int dimension);

  double value(const Point& point) const;
  /// `slope` receives ∂/∂(axis).
  double value_and_slope(const Point& point, int axis, double& slope) const;
  double value_and_gradient(const Point& point, Point& gradient) const;
  /// Rigorous bounds of value and gradient, of second order in the size of the box; see
  /// `Tape::bounds`.
  FunctionBounds bounds(const Box& box) const;

 private:
  enum class Code : std::uint8_t {
    constant,
    quadric,
    x,
    y,
    z,
    add,
    subtract,
    multiply,
    divide,
    negate,
    scale,
    offset,
    square,
    sqrt,
    exp,
    log,
    sin,
    cos,
    hypot,
    min,
    max
  };
  struct Step {
    Code code;
    std::int16_t first = 0;
    std::int16_t second = 0;
    double number = 0;
  };
  static constexpr int capacity = 64;

  class Compiler;
  template <class Rules>
  typename Rules::Number run(const Rules& rules, const Point& point) const;

  template <int N>
  FunctionBounds bounds_in(const Box& box) const;

  int dimension_ = 0;
  std::vector<Step> steps_;
  std::vector<QuadricEvaluator> quadrics_;
};

}  // namespace rfm
