#include "core/level_function.hpp"

#include <algorithm>
#include <set>

#include "core/quadric.hpp"
#include "core/tape.hpp"

namespace rfm {
namespace {

// Breakpoints of all sources that an expression uses.
std::array<std::vector<double>, 3> collect_breakpoints(const Field& field, int dimension) {
  std::array<std::vector<double>, 3> breakpoints;
  std::set<const Field::Node*> seen;
  std::vector<const Field::Node*> pending{&field.node()};
  while (!pending.empty()) {
    const Field::Node* node = pending.back();
    pending.pop_back();
    if (!seen.insert(node).second) continue;
    for (const Field& argument : node->arguments) pending.push_back(&argument.node());
    if (!node->source || !node->arguments.empty()) continue;  // not where the source is
    for (int axis = 0; axis < dimension; ++axis) {
      const std::vector<double> more = node->source->breakpoints(axis);
      breakpoints[axis].insert(breakpoints[axis].end(), more.begin(), more.end());
    }
  }
  for (auto& list : breakpoints) {
    std::ranges::sort(list);
    list.erase(std::unique(list.begin(), list.end()), list.end());
  }
  return breakpoints;
}

}  // namespace

LevelFunction::LevelFunction(const Field& field, int dimension)
    : dimension_(dimension), breakpoints_(collect_breakpoints(field, dimension)) {
  if (const auto quadric = as_quadric(field, dimension))
    quadric_ = std::make_unique<const Quadric>(*quadric);
  else
    tape_ = std::make_unique<const Tape>(std::vector{field}, std::vector{1}, dimension);
}

LevelFunction::~LevelFunction() = default;
LevelFunction::LevelFunction(LevelFunction&&) noexcept = default;
LevelFunction& LevelFunction::operator=(LevelFunction&&) noexcept = default;

double LevelFunction::value(const Point& point) const {
  return quadric_ ? quadric_->value(point) : tape_->value(point);
}

double LevelFunction::value_and_slope(const Point& point, int axis, double& slope) const {
  if (quadric_) {
    slope = quadric_->slope(point, axis);
    return quadric_->value(point);
  }
  Point gradient;
  const double value = tape_->value_and_gradient(point, gradient);
  slope = gradient[axis];
  return value;
}

double LevelFunction::value_and_gradient(const Point& point, Point& gradient) const {
  if (quadric_) {
    gradient = quadric_->gradient(point);
    return quadric_->value(point);
  }
  return tape_->value_and_gradient(point, gradient);
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
  return quadric_ ? quadric_->value_bounds(box) : tape_->value_bounds(box);
}

FunctionBounds LevelFunction::bounds(const Box& box) const {
  if (quadric_) return quadric_->bounds(box);
  FunctionBounds bounds = tape_->bounds(box);
  if (bounds.value.excludes_zero()) return bounds;
  // The mean value form, with the value at the centre enclosed over a box of no extent.
  Box center = box;
  center.low = center.high = box.center();
  Interval mean_value = tape_->value_bounds(center);
  for (int axis = 0; axis < dimension_; ++axis)
    mean_value =
        mean_value + bounds.gradient[axis] * (box.interval(axis) - Interval(center.low[axis]));
  if (bounds.smooth) bounds.value = intersection(bounds.value, mean_value);
  return bounds;
}

}  // namespace rfm
