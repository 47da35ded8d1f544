#include "core/relations.hpp"

#include <algorithm>
#include <cmath>
#include <queue>
#include <vector>

#include "core/error.hpp"
#include "core/least_side.hpp"
#include "core/reach.hpp"

namespace rfm {
namespace {

// What may hold points of the region: the box, cut off by its reach along every axis. Empty where
// it is proved to hold none.
std::optional<Box> contracted(const RegionEvaluator& region, Box box) {
  for (int axis = 0; axis < box.dimension; ++axis)
    for (const bool upper : {false, true}) {
      const std::optional<double> limit = reach(region, box, axis, upper);
      if (!limit) return std::nullopt;
      double& side = (upper ? box.high : box.low)[axis];
      side = upper ? std::min(side, *limit) : std::max(side, *limit);
      if (box.low[axis] > box.high[axis]) return std::nullopt;
    }
  return box;
}

// A point of the region near the middle of a box: the middle itself, or that of a step to the zero
// of a primitive that is violated there.
std::optional<Point> point_near(const RegionEvaluator& region, const Box& box) {
  const Point center = box.center();
  if (region.contains(center)) return center;
  for (int k = 0; k < region.primitive_count(); ++k) {
    Point gradient;
    const double value = region.level(k).value_and_gradient(center, gradient);
    double square = 0;
    for (int axis = 0; axis < box.dimension; ++axis) square += gradient[axis] * gradient[axis];
    if (!(square > 0)) continue;
    Point moved = center;
    // A little beyond the zero, to either side.
    for (const double beyond : {1.001, 1.1}) {
      for (int axis = 0; axis < box.dimension; ++axis)
        moved[axis] = center[axis] - beyond * value / square * gradient[axis];
      if (box.contains(moved) && region.contains(moved)) return moved;
    }
  }
  return std::nullopt;
}

void require_same_dimension(const Region& a, const Region& b) {
  if (a.dimension() != b.dimension())
    throw InvalidArgument("regions of different dimension have no relation");
}

}  // namespace

Truth membership(const RegionEvaluator& region, const Point& point, double tolerance) {
  std::vector<Truth> signs;
  for (int k = 0; k < region.primitive_count(); ++k) {
    Point gradient;
    const double value = region.level(k).value_and_gradient(point, gradient);
    const double margin = tolerance * std::hypot(gradient[0], gradient[1], gradient[2]);
    // Undefined is outside, as for `RegionEvaluator::contains`.
    signs.push_back(value > margin ? Truth::yes : value >= -margin ? Truth::unknown : Truth::no);
  }
  return region.region().expression().evaluate(signs);
}

Relation has_points(const RegionEvaluator& region, const Box& bounds,
                    const RelationOptions& options) {
  const double smallest = std::max(options.resolution * bounds.longest_side(), least_side(bounds));
  Relation relation;
  // Breadth first: a witness is found in the largest box that shows one.
  std::queue<Box> boxes;
  boxes.push(bounds);
  for (; !boxes.empty(); boxes.pop()) {
    const std::optional<Box> box = contracted(region, boxes.front());
    ++relation.boxes;
    if (!box) continue;
    if (const std::optional<Point> point = point_near(region, *box)) {
      relation.answer = Truth::yes;
      relation.witness = point;
      relation.undecided.reset();
      return relation;
    }
    if (box->longest_side() <= smallest || relation.boxes >= options.most_boxes) {
      relation.undecided = *box;
      if (relation.boxes >= options.most_boxes) return relation;
      continue;
    }
    for (const Box& half : bisect(*box, box->longest_axis())) boxes.push(half);
  }
  if (!relation.undecided) relation.answer = Truth::no;
  return relation;
}

Relation intersects(const Region& a, const Region& b, const Box& bounds,
                    const RelationOptions& options) {
  require_same_dimension(a, b);
  return has_points(RegionEvaluator(a & b), bounds, options);
}

Relation lies_in(const Region& inner, const Region& outer, const Box& bounds,
                 const RelationOptions& options) {
  require_same_dimension(inner, outer);
  Relation relation = has_points(RegionEvaluator(inner - outer), bounds, options);
  if (relation.answer == Truth::unknown) return relation;
  relation.answer = relation.answer == Truth::yes ? Truth::no : Truth::yes;
  return relation;
}

}  // namespace rfm
