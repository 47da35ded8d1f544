#include "core/bounding_box.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <queue>
#include <string>
#include <vector>

#include "core/error.hpp"
#include "core/intersection.hpp"
#include "core/primitives.hpp"
#include "core/reach.hpp"
#include "core/relations.hpp"

namespace rfm {
namespace {

constexpr double horizon = 1e15;
constexpr double infinite = std::numeric_limits<double>::infinity();

struct Candidate {
  Box box;
  double reach;  // how far the box extends in the direction of the search, rounded up
  int depth;
  bool settled;  // narrow, and trimmed for the last time
  // The farthest first; of several as far the smallest, so that a flat face is not searched all
  // along its length.
  bool operator<(const Candidate& other) const {
    return reach != other.reach ? reach < other.reach : depth < other.depth;
  }
};

// How boxes are cut off at their far side. Far from the region only trying slab after slab tells;
// near it the bounds of second order do, at once.
enum class Trim { by_slabs, by_reach };

// One side of the bounding box: the largest value of ±x_axis over the region.
class SideSearch {
 public:
  SideSearch(const RegionEvaluator& region, int axis, bool upper, Trim trim)
      : region_(region), axis_(axis), upper_(upper), trim_(trim) {}

  struct Result {
    double side = 0;
    Box extreme;               ///< the box that attains it
    bool converged = true;     ///< within `tolerance` times the length of the box searched
    double found = -infinite;  ///< how far a point of the region lies in the direction
  };
  // Empty if `start` does not meet the region.
  std::optional<Result> run(const Box& start, double tolerance) const {
    constexpr int most_boxes = 5000;  // then the bound at hand, still from outside, is taken
    const double thinnest = tolerance * start.length(axis_);
    std::priority_queue<Candidate> queue;
    // Differences below `thinnest` are rounding.
    const auto enqueue = [&](const std::optional<Box>& box, int depth, bool settled) {
      if (box) queue.push({*box, thinnest * std::ceil(extent(*box) / thinnest), depth, settled});
    };
    const auto push = [&](const Box& box, int depth) {
      enqueue(trim_ == Trim::by_slabs ? without_slabs(box, thinnest) : reached(box), depth, false);
    };
    double found = -infinite;
    const auto try_point = [&](const Point& point) {
      const double far = upper_ ? point[axis_] : -point[axis_];
      if (far > found && region_.contains(point)) found = far;
    };
    push(start, 0);
    for (int visited = 0; !queue.empty(); ++visited) {
      const auto [box, farthest, depth, settled] = queue.top();
      queue.pop();
      const int widest = widest_axis(box, start, std::sqrt(tolerance));
      if (widest < 0 && !settled && trim_ == Trim::by_reach) {
        // Bounds of the value alone may be exact (of quadrics they are).
        enqueue(without_slabs(box, thinnest), depth, true);
        continue;
      }
      if (widest < 0 || visited > most_boxes) {
        // Points of the boundary nearest to the middle of the box, of which each is as near to the
        // extreme as the square of the box.
        for (int k = 0; widest >= 0 && k < region_.primitive_count(); ++k)
          if (const auto zero = nearest_zero(region_.level(k), box.center());
              zero && region_.contains(*zero, 1e-12 * start.longest_side()))
            found = std::max(found, upper_ ? (*zero)[axis_] : -(*zero)[axis_]);
        Result result{upper_ ? farthest : -farthest, box, widest < 0, found};
        result.extreme.low[axis_] = result.extreme.high[axis_] = result.side;
        return result;
      }
      if (trim_ == Trim::by_reach) {
        Point point = box.center();
        try_point(point);
        point[axis_] = upper_ ? box.high[axis_] : box.low[axis_];
        try_point(point);
      }
      for (const Box& half : bisect(box, widest)) push(half, depth + 1);
    }
    return {};
  }

 private:
  double extent(const Box& box) const { return upper_ ? box.high[axis_] : -box.low[axis_]; }

  std::optional<Box> reached(Box box) const {
    const auto farthest = reach(region_, box, axis_, upper_);
    if (!farthest) return {};
    (upper_ ? box.high : box.low)[axis_] = *farthest;
    return box;
  }

  // Takes slabs off the far side as long as they are proved to lie outside the region, thinner and
  // thinner ones.
  std::optional<Box> without_slabs(Box box, double thinnest) const {
    if (region_.contains(box) == Truth::no) return {};
    double& far = upper_ ? box.high[axis_] : box.low[axis_];
    const double rounding =
        0x1p-50 * std::max(std::fabs(box.high[axis_]), std::fabs(box.low[axis_]));
    for (double slab = 0.5 * box.length(axis_); slab > std::max(thinnest, rounding);) {
      Box part = box;
      (upper_ ? part.low : part.high)[axis_] = upper_ ? far - slab : far + slab;
      if (slab < box.length(axis_) && region_.contains(part) == Truth::no)
        far = upper_ ? far - slab : far + slab;
      else
        slab *= 0.5;
    }
    return box.length(axis_) > 0 ? std::optional(box) : std::nullopt;
  }

  // The widest axis, or −1 when all are narrow: of the others, and of that of the search where
  // boxes are not cut off by slabs anyway. Bounds are of second order, so that a box of width √δ
  // has its far side right to δ.
  int widest_axis(const Box& box, const Box& start, double narrow) const {
    int widest = -1;
    double width = narrow;
    for (int axis = 0; axis < box.dimension; ++axis) {
      if (axis == axis_ && trim_ == Trim::by_slabs) continue;
      const double relative = box.length(axis) / start.length(axis);
      if (relative > width) width = relative, widest = axis;
    }
    return widest;
  }

  const RegionEvaluator& region_;
  int axis_;
  bool upper_;
  Trim trim_;
};

// Whether the curve {f = g = 0} runs across `axis` at a point, so that its extreme may lie there.
// (In the plane it is a point.)
bool turns(const LevelFunction& f, const LevelFunction& g, const Point& point, int axis) {
  if (f.dimension() < 3) return true;
  Point a, b;
  f.value_and_gradient(point, a);
  g.value_and_gradient(point, b);
  const Point tangent{a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2],
                      a[0] * b[1] - a[1] * b[0]};
  return std::fabs(tangent[axis]) <= 1e-12 * std::hypot(tangent[0], tangent[1], tangent[2]);
}

// The exact coordinate of a flat face or a corner near the extreme box, or `side` unchanged.
double polished(const RegionEvaluator& region, const Box& extreme, int axis, double side,
                double reach) {
  const Point start = extreme.center();
  Box around = extreme;
  around.low[axis] -= reach;
  around.high[axis] += reach;
  std::vector<int> near;
  for (int k = 0; k < region.primitive_count(); ++k)
    if (!region.region().primitives()[k]->selects_only &&  // else it bounds nothing
        !region.level(k).value_bounds(around).excludes_zero())
      near.push_back(k);
  std::optional<double> best;
  const auto offer = [&](const Point& point) {
    const double distance = std::fabs(point[axis] - side);
    if (distance <= (best ? std::fabs(*best - side) : reach) &&
        region.contains(point, 1e-3 * reach))
      best = point[axis];
  };
  for (int k : near) {
    Point gradient;
    const double value = region.level(k).value_and_gradient(start, gradient);
    double across = 0;
    for (int other = 0; other < extreme.dimension; ++other)
      if (other != axis) across = std::max(across, std::fabs(gradient[other]));
    Point foot = start;
    foot[axis] -= value / gradient[axis];
    if (across <= 1e-14 * std::fabs(gradient[axis])) offer(foot);
  }
  if (best) return *best;  // a face is found more exactly than its corners
  for (std::size_t i = 0; i < near.size(); ++i)
    for (std::size_t j = i + 1; j < near.size(); ++j) {
      const LevelFunction &f = region.level(near[i]), &g = region.level(near[j]);
      if (const auto corner = common_zero(f, g, start); corner && turns(f, g, *corner, axis))
        offer(*corner);
      for (std::size_t k = j + 1; extreme.dimension == 3 && k < near.size(); ++k)
        if (const auto corner = common_zero(f, g, region.level(near[k]), start)) offer(*corner);
    }
  return best.value_or(side);
}

// How far the region stays behind `side` near the extreme box, at most: its distance from what lies
// a length beyond, whose local search finds the place that bisection did not come down to. (Of
// points that touch the direction between them would be lost.)
double shortfall(const RegionEvaluator& region, const Box& extreme, int axis, bool upper,
                 double side) {
  const double length = 2 * extreme.longest_side();
  Box near = extreme, beyond = extreme;
  for (int other = 0; other < extreme.dimension; ++other) {
    near.low[other] -= length;
    near.high[other] += length;
  }
  beyond.low[axis] = beyond.high[axis] = side + (upper ? length : -length);
  const Point start = beyond.center();
  (upper ? beyond.high : beyond.low)[axis] += upper ? length : -length;
  Point outwards{};
  outwards[axis] = upper ? 1 : -1;
  const RegionEvaluator outside(extreme.dimension == 3 ? half_space(start, outwards)
                                                       : half_plane(start, outwards));
  constexpr int few = 100;
  try {
    return distance_between(region, near, outside, beyond, 1e-13 * length, few).distance.high -
           length;
  } catch (const InvalidArgument&) {
    return infinite;
  }
}

std::string direction_name(int axis, bool upper) {
  return std::string(upper ? "+" : "-") + "xyz"[axis];
}

}  // namespace

BoundingBox bounding_box_and_excess(const RegionEvaluator& region) {
  const int dimension = region.dimension();
  const std::optional<Box>& known = region.region().enclosure();
  BoundingBox result;
  Box& box = result.box;
  box.dimension = dimension;
  for (int axis = 0; axis < dimension; ++axis) {
    box.low[axis] = -horizon;
    box.high[axis] = horizon;
  }
  const auto contract = [&](double tolerance, Trim trim) {
    Box next = box;
    for (int axis = 0; axis < dimension; ++axis) {
      for (const bool upper : {false, true}) {
        const auto found = SideSearch(region, axis, upper, trim).run(box, tolerance);
        if (!found) throw InvalidArgument("the region is empty");
        double side = found->side;
        if (trim == Trim::by_reach && found->converged)
          side = polished(region, found->extreme, axis, side,
                          std::sqrt(tolerance) * box.longest_side());
        if (known && trim == Trim::by_reach)
          side = upper ? std::min(side, known->high[axis]) : std::max(side, known->low[axis]);
        if (trim == Trim::by_reach && !found->converged)
          result.excess = std::max(
              result.excess, std::min({(upper ? side : -side) - found->found, box.length(axis),
                                       shortfall(region, found->extreme, axis, upper, side)}));
        (upper ? next.high : next.low)[axis] = side;
      }
    }
    return next;
  };
  if (known) {
    // Enlarged, so that the region does not end on the sides of the box that is searched.
    box = *known;
    for (int axis = 0; axis < dimension; ++axis) {
      if (!(box.length(axis) >= 0)) throw InvalidArgument("the region is empty");
      const double margin = 1e-3 * known->longest_side();
      box.low[axis] -= margin;
      box.high[axis] += margin;
    }
    box = contract(1e-13, Trim::by_reach);
    return result;
  }
  // From the horizon inwards, a factor of about 20 at a time; where bounds over so large boxes are
  // too weak to shrink it, more finely.
  for (double tolerance = 0.05; tolerance > 1e-4;) {
    const Box next = contract(tolerance, Trim::by_slabs);
    bool shrinking = false;
    for (int axis = 0; axis < dimension; ++axis)
      shrinking = shrinking || next.length(axis) < 0.7 * box.length(axis);
    box = next;
    if (!shrinking) tolerance *= 0.1;
  }
  for (int axis = 0; axis < dimension; ++axis)
    for (const bool upper : {false, true})
      if (std::fabs((upper ? box.high : box.low)[axis]) >= 0.9 * horizon)
        throw InvalidArgument("the region is not bounded in the direction " +
                              direction_name(axis, upper));
  box = contract(1e-13, Trim::by_reach);
  return result;
}

Box bounding_box(const RegionEvaluator& region) { return bounding_box_and_excess(region).box; }

}  // namespace rfm
