#include "problems/set_extremes.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/diagnosis.hpp"
#include "core/error.hpp"
#include "core/tape.hpp"
#include "problems/set_integrals.hpp"
#include "solvers/stationary_point.hpp"

namespace rfm {
namespace {

// Two planes that cut each other in the line of a segment in space.
std::vector<Field> planes_through(const Point& from, const Point& to) {
  Point along{};
  int thinnest = 0;
  for (int axis = 0; axis < 3; ++axis) {
    along[axis] = to[axis] - from[axis];
    if (std::fabs(along[axis]) < std::fabs(along[thinnest])) thinnest = axis;
  }
  const auto plane = [&](const Point& normal) {
    Field f = 0.0;
    for (int axis = 0; axis < 3; ++axis) f = f + normal[axis] * (coordinate(axis) - from[axis]);
    return f;
  };
  const auto cross = [](const Point& a, const Point& b) {
    return Point{a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
  };
  Point pole{};
  pole[thinnest] = 1;
  const Point normal = cross(along, pole);
  return {plane(normal), plane(cross(along, normal))};
}

class SetMaximum {
 public:
  SetMaximum(const Field& f, const ThinSet& set, const ScalarProblem& problem, const Grid& grid)
      : f_(f), set_(set), region_(problem.region()), values_({f, set.where}, {0}, set.dimension) {
    scale_ = grid.box().longest_side();
    reach_ = grid.largest_diagonal();
  }

  Extreme run(const std::vector<Point>& points) {
    for (const Point& point : points) offer(point);
    // At an end data may meet that differ, so that f is not defined there.
    for (const Point& end : set_.points) offer(end, false);
    if (!std::isfinite(best_.value))
      throw ComputationError("a probe over a set has no points: no part of it is in the domain");
    const Point start = best_.at;
    std::vector<Field> constraints =
        set_.surface ? std::vector{*set_.surface} : planes_through(set_.points[0], set_.points[1]);
    std::vector<int> active(constraints.size());
    for (std::size_t i = 0; i < active.size(); ++i) active[i] = static_cast<int>(i);
    const auto add_if_near = [&](const Field& field) {
      Point gradient;
      const double value = LevelFunction(field, set_.dimension).value_and_gradient(start, gradient);
      if (std::fabs(value) <= 2 * reach_ * std::hypot(gradient[0], gradient[1], gradient[2]))
        constraints.push_back(field);
    };
    for (const Field& end : set_.ends) add_if_near(end);
    for (const auto& primitive : region_.region().primitives()) add_if_near(primitive->level);
    StationaryPoints stationary(f_, constraints, set_.dimension);
    improve(stationary, active, static_cast<int>(active.size()),
            static_cast<int>(constraints.size()), start);
    return best_;
  }

 private:
  void improve(StationaryPoints& stationary, std::vector<int>& active, int first, int count,
               const Point& start) {
    if (const auto place = stationary.find(active, start, 2 * reach_)) offer(*place, false);
    if (static_cast<int>(active.size()) == set_.dimension) return;
    for (int k = first; k < count; ++k) {
      active.push_back(k);
      improve(stationary, active, k + 1, count, start);
      active.pop_back();
    }
  }

  void offer(const Point& place, bool must_be_defined = true) {
    if (!region_.contains(place, 1e-12 * scale_)) return;
    if (!(values_.value(place, 1) >= -1e-12 * scale_)) return;
    const double value = values_.value(place);
    if (!std::isfinite(value) && !must_be_defined) return;
    if (!std::isfinite(value))
      throw ComputationError("its value is not a finite number at the point " +
                             point_text(place, set_.dimension) +
                             diagnosis_suffix(f_, place, set_.dimension));
    if (value > best_.value) best_ = {value, place};
  }

  const Field& f_;
  const ThinSet& set_;
  const RegionEvaluator& region_;
  Tape values_;
  double scale_ = 1, reach_ = 0;
  Extreme best_{-std::numeric_limits<double>::infinity(), {}};
};

}  // namespace

Extreme maximum_over_set(const Field& f, const ThinSet& set, const ScalarProblem& problem,
                         const Grid& grid) {
  const std::vector<ThinSet> parts = set.parts.empty() ? std::vector{set} : set.parts;
  Extreme best{-std::numeric_limits<double>::infinity(), {}};
  for (const ThinSet& part : parts) {
    const std::vector<Point> points = points_of_set(part, problem, grid);
    // Of a chain some parts may lie outside of the domain.
    if (points.empty() && parts.size() > 1) continue;
    const Extreme other = SetMaximum(f, part, problem, grid).run(points);
    if (other.value > best.value) best = other;
  }
  if (!std::isfinite(best.value))
    throw ComputationError("a probe over a set has no points: no part of it is in the domain");
  return best;
}

}  // namespace rfm
