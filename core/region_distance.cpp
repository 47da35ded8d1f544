#include <algorithm>
#include <cmath>
#include <limits>
#include <queue>
#include <vector>

#include "core/error.hpp"
#include "core/reach.hpp"
#include "core/relations.hpp"

namespace rfm {
namespace {

double separation(const Point& p, const Point& q) {
  return std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]);
}

// The smallest distance of points of two boxes, rounded down.
double gap(const Box& a, const Box& b) {
  double square = 0;
  for (int axis = 0; axis < a.dimension; ++axis) {
    const double along = std::max({0.0, a.low[axis] - b.high[axis], b.low[axis] - a.high[axis]});
    square += along * along;
  }
  return std::sqrt(square) * (1 - 4 * std::numeric_limits<double>::epsilon());
}

// A bound of u·p over the points p of the region in a box. Where a primitive must be f ≥ 0 there,
// u·p ≤ u·p + μ f(p) for every μ ≥ 0, by the mean value form of f; with the μ that leaves least of
// the gradient u + μ∇f the bound is of second order where u is along the normal.
double support(const RegionEvaluator& region, const Box& box, const Point& u) {
  const Point center = box.center();
  const BooleanExpression& expression = region.region().expression();
  std::vector<Truth> signs;
  for (int k = 0; k < region.primitive_count(); ++k) {
    const Interval value = region.level(k).value_bounds(box);
    signs.push_back(value.low >= 0 ? Truth::yes : value.high < 0 ? Truth::no : Truth::unknown);
  }
  Interval middle, best;
  for (int axis = 0; axis < box.dimension; ++axis) {
    middle = middle + Interval(u[axis]) * Interval(center[axis]);
    best = best + Interval(u[axis]) * box.interval(axis);
  }
  Box point = box;
  point.low = point.high = center;
  for (int k = 0; k < region.primitive_count(); ++k) {
    if (signs[k] != Truth::unknown) continue;
    signs[k] = Truth::no;
    const bool must_be_true = expression.evaluate(signs) == Truth::no;
    signs[k] = Truth::yes;
    const bool must_be_false = expression.evaluate(signs) == Truth::no;
    signs[k] = Truth::unknown;
    if (must_be_true == must_be_false) continue;
    const FunctionBounds bounds = region.level(k).bounds(box);
    if (!bounds.smooth) continue;
    double product = 0, square = 0;
    for (int axis = 0; axis < box.dimension; ++axis) {
      const double slope = (must_be_true ? 1 : -1) * bounds.gradient[axis].middle();
      product += u[axis] * slope;
      square += slope * slope;
    }
    if (!(product < 0) || !std::isfinite(product / square)) continue;
    const Interval factor((must_be_true ? -1 : 1) * product / square);
    Interval bound = middle + factor * region.level(k).value_bounds(point);
    for (int axis = 0; axis < box.dimension; ++axis)
      bound = bound + (Interval(u[axis]) + factor * bounds.gradient[axis]) *
                          (box.interval(axis) - Interval(center[axis]));
    if (bound.high < best.high) best = bound;
  }
  return best.high;
}

// The smallest distance of points of both regions in two boxes, or less: that along the line of the
// boxes' centres, if it is the larger.
double gap(const RegionEvaluator& a, const Box& box_a, const RegionEvaluator& b, const Box& box_b) {
  const Point p = box_a.center(), q = box_b.center();
  const double apart = separation(p, q);
  const double plain = gap(box_a, box_b);
  if (!(apart > 0)) return plain;
  Point u{}, back{};
  for (int axis = 0; axis < box_a.dimension; ++axis) {
    u[axis] = (q[axis] - p[axis]) / apart;
    back[axis] = -u[axis];
  }
  // u may be a little longer than 1.
  constexpr double rounding = 1 - 8 * std::numeric_limits<double>::epsilon();
  const double along = (Interval(-support(b, box_b, back)) - Interval(support(a, box_a, u))).low;
  return std::max(plain, along * rounding);
}

struct Pair {
  Box a, b;
  double least;
  bool operator<(const Pair& other) const { return least > other.least; }
};

class NearestPair {
 public:
  NearestPair(const RegionEvaluator& a, const RegionEvaluator& b) : a_(a), b_(b) {}

  RegionDistance run(const Box& bounds_a, const Box& bounds_b, double tolerance, int most_pairs) {
    result_.distance.high = std::numeric_limits<double>::infinity();
    offer(bounds_a, bounds_b);
    const double smallest = 1e-12 * std::max(bounds_a.longest_side(), bounds_b.longest_side());
    while (!queue_.empty()) {
      const Pair pair = queue_.top();
      result_.distance.low = std::min(pair.least, result_.distance.high);
      const bool resolved = pair.a.longest_side() <= smallest && pair.b.longest_side() <= smallest;
      if (pair.least >= result_.distance.high - tolerance || resolved ||
          result_.pairs >= most_pairs)
        break;
      queue_.pop();
      const bool divide_a = pair.a.longest_side() >= pair.b.longest_side();
      const Box& wide = divide_a ? pair.a : pair.b;
      for (const Box& half : bisect(wide, wide.longest_axis()))
        divide_a ? offer(half, pair.b) : offer(pair.a, half);
    }
    if (!std::isfinite(result_.distance.high)) throw InvalidArgument("a region is empty");
    return result_;
  }

 private:
  void offer(Box a, Box b) {
    ++result_.pairs;
    if (!contract(a_, a) || !contract(b_, b)) return;
    const double least = gap(a_, a, b_, b);
    if (least >= result_.distance.high) return;
    witness(a, b);
    queue_.push({a, b, least});
  }

  static bool contract(const RegionEvaluator& region, Box& box) {
    if (region.contains(box) == Truth::yes) return true;
    for (int axis = 0; axis < box.dimension; ++axis)
      for (const bool upper : {false, true}) {
        const auto limit = reach(region, box, axis, upper);
        if (!limit) return false;
        double& side = (upper ? box.high : box.low)[axis];
        side = upper ? std::min(side, *limit) : std::max(side, *limit);
        if (box.low[axis] > box.high[axis]) return false;
      }
    return true;
  }

  // Points of both regions in the boxes, moved towards each other as far as they stay inside.
  void witness(const Box& a, const Box& b) {
    const Point p = a.center(), q = b.center();
    if (!a_.contains(p) || !b_.contains(q)) {
      // Of a box across the boundary the far side may be inside.
      witness_from(a, b);
      return;
    }
    keep(p, q);
  }
  void witness_from(const Box& a, const Box& b) {
    std::optional<Point> first = inside(a_, a), second = inside(b_, b);
    if (first && second) keep(*first, *second);
  }
  static std::optional<Point> inside(const RegionEvaluator& region, const Box& box) {
    if (region.contains(box.center())) return box.center();
    for (int corner = 0; corner < 1 << box.dimension; ++corner) {
      Point point{};
      for (int axis = 0; axis < box.dimension; ++axis)
        point[axis] = (corner >> axis & 1) != 0 ? box.high[axis] : box.low[axis];
      if (region.contains(point)) return point;
    }
    return std::nullopt;
  }
  void keep(Point p, Point q) {
    for (int turn = 0; turn < 2; ++turn) {
      p = advanced(a_, p, q);
      q = advanced(b_, q, p);
    }
    const double apart = separation(p, q) * (1 + 4 * std::numeric_limits<double>::epsilon());
    if (apart >= result_.distance.high) return;
    result_.distance.high = apart;
    result_.first = p;
    result_.second = q;
  }
  // The last point inside on the way from one inside.
  static Point advanced(const RegionEvaluator& region, const Point& from, const Point& to) {
    if (region.contains(to)) return to;
    double inside = 0, outside = 1;
    const auto at = [&](double t) {
      return Point{from[0] + t * (to[0] - from[0]), from[1] + t * (to[1] - from[1]),
                   from[2] + t * (to[2] - from[2])};
    };
    for (int step = 0; step < 50; ++step) {
      const double middle = 0.5 * (inside + outside);
      (region.contains(at(middle)) ? inside : outside) = middle;
    }
    return at(inside);
  }

  const RegionEvaluator &a_, &b_;
  std::priority_queue<Pair> queue_;
  RegionDistance result_;
};

}  // namespace

RegionDistance distance_between(const RegionEvaluator& a, const Box& bounds_a,
                                const RegionEvaluator& b, const Box& bounds_b, double tolerance,
                                int most_pairs) {
  if (a.dimension() != b.dimension())
    throw InvalidArgument("regions of different dimension have no relation");
  return NearestPair(a, b).run(bounds_a, bounds_b, tolerance, most_pairs);
}

}  // namespace rfm
