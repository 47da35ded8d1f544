#include <algorithm>
#include <cmath>
#include <limits>
#include <queue>
#include <vector>

#include "core/error.hpp"
#include "core/reach.hpp"
#include "core/relations.hpp"
#include "core/shortest_way.hpp"

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
double support(const RegionPart& part, const Point& u) {
  const Box& box = part.box;
  const Point center = box.center();
  Interval middle, best;
  for (int axis = 0; axis < box.dimension; ++axis) {
    middle = middle + Interval(u[axis]) * Interval(center[axis]);
    best = best + Interval(u[axis]) * box.interval(axis);
  }
  Box point = box;
  point.low = point.high = center;
  for (const auto& [primitive, sign] : part.signs) {
    const LevelFunction& level = part.region->level(primitive);
    const FunctionBounds bounds = level.bounds(box);
    if (!bounds.smooth) continue;
    double product = 0, square = 0;
    for (int axis = 0; axis < box.dimension; ++axis) {
      const double slope = sign * bounds.gradient[axis].middle();
      product += u[axis] * slope;
      square += slope * slope;
    }
    if (!(product < 0) || !std::isfinite(product / square)) continue;
    const Interval factor(-sign * product / square);
    Interval bound = middle + factor * level.value_bounds(point);
    for (int axis = 0; axis < box.dimension; ++axis)
      bound = bound + (Interval(u[axis]) + factor * bounds.gradient[axis]) *
                          (box.interval(axis) - Interval(center[axis]));
    if (bound.high < best.high) best = bound;
  }
  return best.high;
}

// The smallest distance of points of both parts along the line of their boxes' centres, or less.
double gap_along(const RegionPart& a, const RegionPart& b) {
  const Point p = a.box.center(), q = b.box.center();
  const double apart = separation(p, q);
  if (!(apart > 0)) return 0;
  Point u{}, back{};
  for (int axis = 0; axis < a.box.dimension; ++axis) {
    u[axis] = (q[axis] - p[axis]) / apart;
    back[axis] = -u[axis];
  }
  // u may be a little longer than 1.
  constexpr double rounding = 1 - 8 * std::numeric_limits<double>::epsilon();
  return (Interval(-support(b, back)) - Interval(support(a, u))).low * rounding;
}

struct Pair {
  Box a, b;
  double least;
  bool operator<(const Pair& other) const { return least > other.least; }
};

class NearestPair {
 public:
  NearestPair(const RegionEvaluator& a, const RegionEvaluator& b)
      : a_(a), b_(b), second_a_(a), second_b_(b) {}

  RegionDistance run(const Box& bounds_a, const Box& bounds_b, double tolerance, int most_pairs) {
    result_.distance.high = std::numeric_limits<double>::infinity();
    bounds_a_ = bounds_a;
    bounds_b_ = bounds_b;
    offer(bounds_a, bounds_b, 0);
    const double smallest = 1e-12 * std::max(bounds_a.longest_side(), bounds_b.longest_side());
    while (!queue_.empty()) {
      const Pair pair = queue_.top();
      result_.distance.low = std::min(pair.least, result_.distance.high);
      const bool resolved = pair.a.longest_side() <= smallest && pair.b.longest_side() <= smallest;
      // Without points of both regions there is nothing to tell yet.
      const bool spent = result_.pairs >= most_pairs &&
                         (std::isfinite(result_.distance.high) || result_.pairs >= 100000);
      if (pair.least >= result_.distance.high - tolerance || resolved || spent) break;
      queue_.pop();
      const bool divide_a = pair.a.longest_side() >= pair.b.longest_side();
      const Box& wide = divide_a ? pair.a : pair.b;
      for (const Box& half : bisect(wide, wide.longest_axis()))
        divide_a ? offer(half, pair.b, pair.least) : offer(pair.a, half, pair.least);
    }
    if (!std::isfinite(result_.distance.high))
      throw InvalidArgument(queue_.empty() ? "a region is empty"
                                           : "no points of both regions were found");
    return result_;
  }

 private:
  // `known` holds for the pair of boxes from which this one comes.
  void offer(Box a, Box b, double known) {
    ++result_.pairs;
    if (!contract(a_, a) || !contract(b_, b)) return;
    double least = std::max(known, gap(a, b));
    if (least >= result_.distance.high) return;
    const RegionPart first{&a_, &second_a_, a, necessary_signs(a_, a)};
    const RegionPart second{&b_, &second_b_, b, necessary_signs(b_, b)};
    least = std::max(least, gap_along(first, second));
    if (least >= result_.distance.high) return;
    witness(a, b);
    if (!first.signs.empty() && !second.signs.empty()) {
      const ShortestWay way(first, second);
      witness(way);
      least = std::max(least, way.at_least());
    }
    if (least < result_.distance.high) queue_.push({a, b, least});
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
  // The ends of a way that is the shortest in its neighbourhood.
  void witness(const ShortestWay& way) {
    if (separation(way.end(0), way.end(1)) >= result_.distance.high) return;
    const std::optional<Point> first = pushed(a_, bounds_a_, way.end(0), way.inwards(0));
    if (!first) return;
    if (const auto second = pushed(b_, bounds_b_, way.end(1), way.inwards(1)))
      keep_if_nearer(*first, *second);
  }
  // A point on the boundary up to rounding, pushed as little as it takes to be inside.
  static std::optional<Point> pushed(const RegionEvaluator& region, const Box& bounds,
                                     const Point& from, const Point& direction) {
    const double size = bounds.longest_side();
    for (double step = 0; step < 1e-10 * size; step = std::max(2 * step, 1e-17 * size)) {
      const Point point{from[0] + step * direction[0], from[1] + step * direction[1],
                        from[2] + step * direction[2]};
      if (region.contains(point)) {
        for (int axis = 0; axis < bounds.dimension; ++axis)
          if (point[axis] < bounds.low[axis] - 1e-12 * size ||
              point[axis] > bounds.high[axis] + 1e-12 * size)
            return std::nullopt;
        return point;
      }
    }
    return std::nullopt;
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
    keep_if_nearer(p, q);
  }
  void keep_if_nearer(const Point& p, const Point& q) {
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
  SecondDerivatives second_a_, second_b_;
  Box bounds_a_, bounds_b_;
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
