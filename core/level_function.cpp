#include "core/level_function.hpp"

#include <algorithm>
#include <cmath>

#include "core/point_program.hpp"
#include "core/source_breakpoints.hpp"
#include "core/tape.hpp"

namespace rfm {
namespace {

Interval within(const Interval& range, const Interval& bounds) {
  return {std::max(range.low, bounds.low), std::min(range.high, bounds.high)};
}

// Bounds over all of space by plain intervals. Sources know themselves over finite boxes only.
Interval range_everywhere(const Field& field, int dimension) {
  if (!sources_of(field).empty()) return Interval::entire();
  Box everywhere;
  everywhere.dimension = dimension;
  // Not all of it: the entire line stands for values that may be no numbers.
  constexpr double far = 1e100;
  everywhere.low.fill(-far);
  everywhere.high.fill(far);
  const Interval range = Tape({field}, {0}, dimension).value_bounds(everywhere);
  return {std::isnan(range.low) ? -INFINITY : range.low,
          std::isnan(range.high) ? INFINITY : range.high};
}

// A normal turned by 90° has a component of 1e-16 where 0 is meant, and a face that lies on a grid
// line but for that is a graph over neither axis within it, on this side of the line or the other
// by chance. Turned by less than the rounding of its own coefficients such a face is parallel to an
// axis, and so is a cylinder.
Quadric without_residues(Quadric quadric) {
  constexpr double residue = 0x1p-51;
  double most_square = 0, most_linear = 0;
  for (const double a : quadric.square) most_square = std::max(most_square, std::fabs(a));
  for (const double b : quadric.linear) most_linear = std::max(most_linear, std::fabs(b));
  const auto square = [&](int i, int j) -> double& {
    return quadric.square[Quadric::square_index(i, j)];
  };
  for (int i = 0; i < 3; ++i)
    for (int j = i + 1; j < 3; ++j)
      if (std::fabs(square(i, j)) <=
          residue * std::max(std::fabs(square(i, i)), std::fabs(square(j, j))))
        square(i, j) = 0;
  // The gradient where the quadric vanishes.
  const double slope = std::max(most_linear, std::sqrt(most_square * std::fabs(quadric.constant)));
  for (int i = 0; i < 3; ++i) {
    if (std::fabs(square(i, i)) <= residue * residue * most_square) square(i, i) = 0;
    const bool alone = square(i, 0) == 0 && square(i, 1) == 0 && square(i, 2) == 0;
    if (alone && std::fabs(quadric.linear[i]) <= residue * slope) quadric.linear[i] = 0;
  }
  return quadric;
}

}  // namespace

LevelFunction::LevelFunction(const Field& field, int dimension)
    : dimension_(dimension),
      range_(range_everywhere(field, dimension)),
      breakpoints_(source_breakpoints(field, dimension)) {
  if (const auto quadric = as_quadric(field, dimension)) {
    quadric_.emplace(without_residues(*quadric));
    return;
  }
  if (auto program = PointProgram::compiled(field, dimension))
    program_ = std::make_unique<const PointProgram>(*std::move(program));
  tape_ = std::make_unique<const Tape>(std::vector{field}, std::vector{1}, dimension);
}

LevelFunction::~LevelFunction() = default;
LevelFunction::LevelFunction(LevelFunction&&) noexcept = default;
LevelFunction& LevelFunction::operator=(LevelFunction&&) noexcept = default;

double LevelFunction::other_value(const Point& point) const {
  return program_ ? program_->value(point) : tape_->value(point);
}

double LevelFunction::other_slope(const Point& point, int axis, double& slope) const {
  if (program_) return program_->value_and_slope(point, axis, slope);
  Point gradient;
  const double value = other_gradient(point, gradient);
  slope = gradient[axis];
  return value;
}

double LevelFunction::other_gradient(const Point& point, Point& gradient) const {
  return program_ ? program_->value_and_gradient(point, gradient)
                  : tape_->value_and_gradient(point, gradient);
}

double LevelFunction::value_and_slope(const Line& line, double t, double& slope) const {
  Point gradient;
  const double value = value_and_gradient(line.at(t), gradient);
  slope = gradient[0] * line.direction[0] + gradient[1] * line.direction[1] +
          gradient[2] * line.direction[2];
  return value;
}

LineBounds LevelFunction::bounds(const Line& line, const Interval& range) const {
  return quadric_ ? quadric_->bounds(line, range) : tape_->bounds(line, range);
}

std::optional<LinePolynomial> LevelFunction::polynomial_along(const Line& line) const {
  if (!quadric_) return {};
  return quadric_->along(line);
}

Interval LevelFunction::value_bounds(const Box& box) const {
  return within(range_, quadric_ ? quadric_->value_bounds(box) : tape_->value_bounds(box));
}

FunctionBounds LevelFunction::bounds(const Box& box) const {
  FunctionBounds bounds = quadric_   ? quadric_->bounds(box)
                          : program_ ? program_->bounds(box)
                                     : tape_->bounds(box);
  bounds.value = within(range_, bounds.value);
  return bounds;
}

}  // namespace rfm
