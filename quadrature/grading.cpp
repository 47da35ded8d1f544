#include "quadrature/grading.hpp"

#include <algorithm>
#include <cmath>

#include "core/error.hpp"

namespace rfm {
namespace {

// Parts of `box` between the coordinates `places` of each axis.
template <class Visit>
void visit_pieces(const Box& box, const std::array<std::array<double, 2>, 3>& places, int axis,
                  Visit&& visit) {
  // Both bounds, or GCC 12 unrolls beyond the last axis.
  if (axis >= 3 || axis == box.dimension) return visit(box);
  Box piece = box;
  for (const double place : places[axis]) {
    if (!(place > piece.low[axis] && place < box.high[axis])) continue;
    piece.high[axis] = place;
    visit_pieces(piece, places, axis + 1, visit);
    piece.low[axis] = place;
  }
  piece.high[axis] = box.high[axis];
  visit_pieces(piece, places, axis + 1, visit);
}

class GradedParts {
 public:
  GradedParts(const Grading& grading, double spacing, const std::function<void(const Box&)>& visit)
      : grading_(grading), reach_(grading.reach > 0 ? grading.reach : spacing), visit_(visit) {
    int axes = 0;
    for (int axis = 0; axis < 3; ++axis) axes += grading.from[axis] != grading.to[axis];
    is_straight_ = axes <= 1 && grading.curve.empty();
  }

  void run(const Box& box) {
    if (is_straight_)
      straight(box, 0);
    else
      oblique(box);
  }

  bool reaches(const Box& box) const {
    return is_straight_ ? overlaps(box, around(box, 0)) : is_within(box, reach_);
  }

 private:
  // Q_k.
  Box around(const Box& box, int level) const {
    const double distance = reach_ * std::pow(grading_.ratio, level);
    Box result = box;
    for (int axis = 0; axis < box.dimension; ++axis) {
      const auto [low, high] = std::minmax(grading_.from[axis], grading_.to[axis]);
      result.low[axis] = low - distance;
      result.high[axis] = high + distance;
    }
    return result;
  }

  static bool overlaps(const Box& a, const Box& b) {
    for (int axis = 0; axis < a.dimension; ++axis)
      if (!(a.low[axis] < b.high[axis] && b.low[axis] < a.high[axis])) return false;
    return true;
  }

  void straight(const Box& box, int level) {
    std::array<std::array<double, 2>, 3> places{};
    if (level > grading_.levels) {
      // The ends of the segment, and across it the segment itself.
      for (int axis = 0; axis < box.dimension; ++axis) {
        const auto [low, high] = std::minmax(grading_.from[axis], grading_.to[axis]);
        places[axis] = {low, high};
      }
      return visit_pieces(box, places, 0, visit_);
    }
    const Box inner = around(box, level);
    if (!overlaps(box, inner)) return visit_(box);
    for (int axis = 0; axis < box.dimension; ++axis)
      places[axis] = {inner.low[axis], inner.high[axis]};
    visit_pieces(box, places, 0, [&](const Box& piece) {
      overlaps(piece, inner) ? straight(piece, level + 1) : visit_(piece);
    });
  }

  // The distance in the maximum norm from the segment, which is convex along it.
  double distance(const Box& box) const {
    const auto at = [&](double t) {
      double largest = 0;
      for (int axis = 0; axis < box.dimension; ++axis) {
        const double x = grading_.from[axis] + t * (grading_.to[axis] - grading_.from[axis]);
        largest = std::max({largest, box.low[axis] - x, x - box.high[axis]});
      }
      return largest;
    };
    double low = 0, high = 1;
    for (int step = 0; step < 60 && high - low > 1e-12; ++step) {
      const double third = (high - low) / 3;
      at(low + third) <= at(high - third) ? high -= third : low += third;
    }
    return at(0.5 * (low + high));
  }

  // False only if the segment or curve is no nearer to the box, in the maximum norm.
  bool is_within(const Box& box, double away) const {
    if (grading_.curve.empty()) return distance(box) < away;
    Box around = box;
    for (int axis = 0; axis < box.dimension; ++axis) {
      around.low[axis] -= away;
      around.high[axis] += away;
    }
    return std::ranges::all_of(grading_.curve, [&](const auto& function) {
      const Interval value = function->bounds(around).value;
      return !(value.low > 0 || value.high < 0);
    });
  }

  void oblique(const Box& box) {
    const double size = box.longest_side();
    if (!is_within(box, std::min(size, reach_))) return visit_(box);
    if (size > reach_ * std::pow(grading_.ratio, grading_.levels)) {
      std::array<std::array<double, 2>, 3> middle{};
      for (int axis = 0; axis < box.dimension; ++axis)
        middle[axis].fill(0.5 * (box.low[axis] + box.high[axis]));
      return visit_pieces(box, middle, 0, [&](const Box& piece) { oblique(piece); });
    }
    // Aslant, so that no Gauss point lies on a segment that is a diagonal, or on such a curve.
    std::array<std::array<double, 2>, 3> places{};
    constexpr std::array<double, 3> aslant{0.4142, 0.5772, 0.4812};
    for (int axis = 0; axis < box.dimension; ++axis)
      places[axis].fill(box.low[axis] + aslant[axis] * box.length(axis));
    visit_pieces(box, places, 0, visit_);
  }

  const Grading& grading_;
  double reach_;
  const std::function<void(const Box&)>& visit_;
  bool is_straight_ = true;
};

}  // namespace

void check(const Grading& grading) {
  if (grading.levels < 0 || grading.levels > 60)
    throw InvalidArgument("a grading has 0 to 60 levels");
  if (!(grading.ratio > 0 && grading.ratio < 1))
    throw InvalidArgument("the ratio of a grading lies between 0 and 1");
  if (!(grading.reach >= 0 && std::isfinite(grading.reach)))
    throw InvalidArgument("the reach of a grading is finite and not negative");
  for (const Point& point : {grading.from, grading.to})
    if (!std::isfinite(point[0] + point[1] + point[2]))
      throw InvalidArgument("the ends of a grading are finite");
}

Grading towards_curve(const std::vector<Field>& functions, int dimension, int levels) {
  Grading grading;
  grading.levels = levels;
  for (const Field& function : functions)
    grading.curve.push_back(std::make_shared<LevelFunction>(function, dimension));
  return grading;
}

bool lies_on(const Grading& grading, int dimension, const Point& point) {
  if (!grading.curve.empty()) return false;
  int axes = 0;
  for (int axis = 0; axis < dimension; ++axis) {
    const auto [low, high] = std::minmax(grading.from[axis], grading.to[axis]);
    if (!(low <= point[axis] && point[axis] <= high)) return false;
    axes += low != high;
  }
  return axes <= 1;
}

void visit_graded_parts(const Box& box, std::span<const Grading> gradings, double spacing,
                        const std::function<void(const Box&)>& visit) {
  if (gradings.empty()) return visit(box);
  const std::function<void(const Box&)> next = [&](const Box& part) {
    visit_graded_parts(part, gradings.subspan(1), spacing, visit);
  };
  GradedParts(gradings[0], spacing, next).run(box);
}

bool is_graded(const Box& box, std::span<const Grading> gradings, double spacing) {
  const std::function<void(const Box&)> ignore = [](const Box&) {};
  return std::ranges::any_of(gradings, [&](const Grading& grading) {
    return GradedParts(grading, spacing, ignore).reaches(box);
  });
}

}  // namespace rfm
