#include "core/relations.hpp"

#include <algorithm>
#include <cmath>
#include <queue>
#include <span>
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

// A point of the region in a box that `is_empty` does not exclude.
template <class IsEmpty>
Relation search(const RegionEvaluator& region, const Box& bounds, const RelationOptions& options,
                const IsEmpty& is_empty) {
  const double smallest = std::max(options.resolution * bounds.longest_side(), least_side(bounds));
  Relation relation;
  // Breadth first: a witness is found in the largest box that shows one.
  std::queue<Box> boxes;
  boxes.push(bounds);
  for (; !boxes.empty(); boxes.pop()) {
    const std::optional<Box> box = contracted(region, boxes.front());
    ++relation.boxes;
    if (!box || is_empty(*box)) continue;
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

// Whether signs alone prove an inclusion: where both regions have boundary in common, no box is
// small enough for bounds to separate them.
class Inclusion {
 public:
  Inclusion(const Region& inner, const Region& outer, const RegionEvaluator& difference)
      : difference_(difference), inner_(inner.expression()), outer_(outer.expression()) {
    const auto& primitives = difference.region().primitives();
    std::vector<int> number;
    for (const auto& primitive : outer.primitives())
      number.push_back(
          static_cast<int>(std::ranges::find(primitives, primitive) - primitives.begin()));
    outer_ = outer_.renamed(number);
    shared_.resize(primitives.size());
    for (const int k : number) shared_[k] = k < static_cast<int>(inner.primitives().size());
  }

  // No signs (0 among them) of the primitives that are undecided over the box are those of a point
  // inside the one and outside the other. Both are closed: !p holds where p is 0.
  bool holds(const Box& box) const {
    constexpr std::size_t most = 6;  // 729 combinations
    std::vector<Truth> signs;
    std::vector<int> open;
    bool any_shared = false;
    for (int k = 0; k < difference_.primitive_count(); ++k) {
      const Interval range = difference_.level(k).value_bounds(box);
      signs.push_back(range.low > 0 ? Truth::yes : range.high < 0 ? Truth::no : Truth::unknown);
      if (signs.back() != Truth::unknown) continue;
      open.push_back(k);
      any_shared = any_shared || shared_[k];
    }
    return any_shared && open.size() <= most && holds(signs, open);
  }

 private:
  bool holds(std::vector<Truth>& signs, std::span<const int> open) const {
    if (open.empty())
      return inner_.evaluate(signs) == Truth::no || outer_.evaluate(signs) != Truth::no;
    for (const Truth sign : {Truth::yes, Truth::unknown, Truth::no}) {
      signs[open.front()] = sign;
      if (!holds(signs, open.subspan(1))) return false;
    }
    return true;
  }

  const RegionEvaluator& difference_;
  BooleanExpression inner_, outer_;  // in the primitives of the difference
  std::vector<bool> shared_;         // by both
};

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
  return search(region, bounds, options, [](const Box&) { return false; });
}

Relation intersects(const Region& a, const Region& b, const Box& bounds,
                    const RelationOptions& options) {
  require_same_dimension(a, b);
  return has_points(RegionEvaluator(a & b), bounds, options);
}

Relation lies_in(const Region& inner, const Region& outer, const Box& bounds,
                 const RelationOptions& options) {
  require_same_dimension(inner, outer);
  const RegionEvaluator difference(inner - outer);
  const Inclusion inclusion(inner, outer, difference);
  Relation relation =
      search(difference, bounds, options, [&](const Box& box) { return inclusion.holds(box); });
  if (relation.answer == Truth::unknown) return relation;
  relation.answer = relation.answer == Truth::yes ? Truth::no : Truth::yes;
  return relation;
}

}  // namespace rfm
