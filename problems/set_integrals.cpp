#include "problems/set_integrals.hpp"

#include <algorithm>
#include <cmath>

#include "core/boundary_part.hpp"
#include "core/closed_along.hpp"
#include "core/error.hpp"
#include "core/tape.hpp"
#include "quadrature/segment_rule.hpp"
#include "solvers/integrate.hpp"

namespace rfm {
namespace {

constexpr int points = 8;

bool is_straight(const ThinSet& set) { return set.points.size() == 2 && set.bulge == 0; }

// The points of a segment itself.
std::array<double, 2> over_segment(const Field& f, const ThinSet& set,
                                   const RegionEvaluator& region, const Grid& grid) {
  const VolumePoints rule =
      make_segment_rule(region, set.points[0], set.points[1], grid.spacing(0), points);
  const Tape tape({f}, {0}, set.dimension);
  double integral = 0, measure = 0;
  for (int i = 0; i < rule.size(); ++i) {
    integral += rule.weights[i] * tape.value(rule.point(i));
    measure += rule.weights[i];
  }
  if (!std::isfinite(integral)) throw ComputationError("the value is not a finite number");
  return {integral, measure};
}

// Cells of the same size in a box around a triangle alone, off its middle, so that no line of the
// grid lies on a triangle across an axis.
Grid around_triangle(const ThinSet& triangle, const Grid& grid) {
  Box box{3, triangle.points[0], triangle.points[0]};
  std::array<int, 3> cells{};
  for (int axis = 0; axis < 3; ++axis) {
    for (const Point& corner : triangle.points) {
      box.low[axis] = std::min(box.low[axis], corner[axis]);
      box.high[axis] = std::max(box.high[axis], corner[axis]);
    }
    const double spacing = grid.spacing(axis);
    cells[axis] = static_cast<int>(std::ceil(box.length(axis) / spacing + 0.1));
    const double beyond = 0.5 * (cells[axis] * spacing - box.length(axis));
    box.low[axis] -= 0.87 * beyond;
    box.high[axis] += 1.13 * beyond;
  }
  return Grid(box, cells);
}

// With a part of a cell more on every side.
Grid enlarged(const Grid& grid) {
  Box box = grid.box();
  std::array<int, 3> cells{1, 1, 1};
  for (int axis = 0; axis < grid.dimension(); ++axis) {
    box.low[axis] -= 0.37 * grid.spacing(axis);
    box.high[axis] += 0.63 * grid.spacing(axis);
    cells[axis] = grid.cells(axis) + 1;
  }
  return Grid(box, cells);
}

// The surface is an interface, split where the set ends.
DomainRule rule_on_surface(const ThinSet& set, const RegionEvaluator& region, const Grid& grid) {
  std::vector<LevelFunction> interfaces;
  interfaces.emplace_back(*set.surface, set.dimension);
  for (const Field& end : set.ends) interfaces.emplace_back(end, set.dimension);
  QuadratureOptions options;
  options.inside_points = 1;
  options.cut_points = points;
  options.compare_orders = false;
  const Grid cells = set.points.size() == 3 ? around_triangle(set, grid) : grid;
  std::vector<int> shared;
  for (int k = 0; k < region.primitive_count(); ++k)
    if (same_surface(region.region().primitives()[k]->level, *set.surface, set.dimension))
      shared.push_back(k);
  if (shared.empty()) return make_domain_rule(region, cells, options, interfaces);
  // On the boundary: what the closed domain holds of it, in cells of which none ends there.
  const RegionEvaluator along(closed_along(region, shared, cells.box()));
  return make_domain_rule(along, set.points.size() == 3 ? cells : enlarged(cells), options,
                          interfaces);
}

}  // namespace

std::array<double, 2> integrated_over_set(const Field& f, const ThinSet& set,
                                          const ScalarProblem& problem, const Grid& grid) {
  std::array<double, 2> sum{};
  for (const ThinSet& part : set.parts) {
    const std::array<double, 2> more = integrated_over_set(f, part, problem, grid);
    for (int i = 0; i < 2; ++i) sum[i] += more[i];
  }
  if (!set.parts.empty()) return sum;
  if (is_straight(set)) return over_segment(f, set, problem.region(), grid);
  const DomainRule rule = rule_on_surface(set, problem.region(), grid);
  const Field inside = step(set.where);
  const IntegrationPlace place{Contribution::Place::interface, {0}};
  const std::array<Coefficient, 2> integrands{Coefficient(inside * f), Coefficient(inside)};
  const std::vector<double> sums = integrate(integrands, rule, place);
  return {sums[0], sums[1]};
}

std::vector<Point> points_of_set(const ThinSet& set, const ScalarProblem& problem,
                                 const Grid& grid) {
  std::vector<Point> list;
  if (is_straight(set)) {
    const VolumePoints rule =
        make_segment_rule(problem.region(), set.points[0], set.points[1], grid.spacing(0), points);
    for (int i = 0; i < rule.size(); ++i) list.push_back(rule.point(i));
    return list;
  }
  const DomainRule rule = rule_on_surface(set, problem.region(), grid);
  const Tape where({set.where}, {0}, set.dimension);
  const SurfacePoints& on = rule.interfaces().points;
  for (int i = 0; i < on.size(); ++i)
    if (on.numbers[i] == 0 && where.value(on.point(i)) >= 0) list.push_back(on.point(i));
  return list;
}

}  // namespace rfm
