#include "solvers/greville_collocation.hpp"

#include <algorithm>

#include "basis/web_extension.hpp"
#include "core/error.hpp"
#include "core/grid_splines.hpp"
#include "solvers/equations.hpp"
#include "solvers/free_functions.hpp"
#include "solvers/solution.hpp"

namespace rfm {
namespace {

// On the boundary the weight vanishes and with it, at a corner, the equation.
constexpr double distance_from_boundary = 1e-6;  // of a cell

struct GrevilleSpace {
  std::vector<bool> inner;  // by function
  CollocationPoints points;
};

GrevilleSpace greville_space(const TensorProductSpace& space, const RegionEvaluator& region) {
  const Grid& grid = space.grid();
  GrevilleSpace result{std::vector<bool>(static_cast<std::size_t>(space.size()), false), {}};
  std::vector<std::vector<Point>> of_cell(static_cast<std::size_t>(grid.cell_count()));
  double margin = grid.smallest_width(0);
  for (int axis = 0; axis < grid.dimension(); ++axis)
    margin = std::min(margin, grid.smallest_width(axis));
  margin *= distance_from_boundary;
  for (int function = 0; function < space.size(); ++function) {
    const std::array<int, 3> place = space.place(space.spline_of_function(function));
    Point point{};
    std::array<int, 3> cell{};
    Box around{grid.dimension(), {}, {}};
    bool within = true;
    for (int axis = 0; axis < grid.dimension(); ++axis) {
      point[axis] = greville_point(grid, axis, space.degree(), place[axis]);
      within = within && point[axis] > grid.box().low[axis] && point[axis] < grid.box().high[axis];
      cell[axis] = grid.locate(axis, point[axis]);
      around.low[axis] = point[axis] - margin;
      around.high[axis] = point[axis] + margin;
    }
    if (!within || region.contains(around) != Truth::yes) continue;
    result.inner[function] = true;
    of_cell[grid.number(cell)].push_back(point);
  }
  result.points.begin.push_back(0);
  for (int cell = 0; cell < grid.cell_count(); ++cell) {
    // As if a spline had a cell of its own.
    double measure = 1;
    for (int axis = 0; axis < grid.dimension(); ++axis)
      measure *= grid.width(axis, grid.position(cell)[axis]);
    for (const Point& point : of_cell[cell])
      result.points.points.add(grid.dimension(), point, measure);
    result.points.begin.push_back(result.points.points.size());
  }
  return result;
}

}  // namespace

NewtonSolution solve_greville(std::span<const Structure> structures,
                              std::span<const TensorProductSpace> spaces,
                              std::span<const Form> forms, const RegionEvaluator& region,
                              const DomainRule& rule, const NewtonOptions& options) {
  std::vector<CollocationPoints> points;
  std::vector<Eigen::Triplet<double, std::int64_t>> entries;
  Eigen::Index rows = 0, columns = 0;
  std::vector<Eigen::Index> inner_functions;
  for (const TensorProductSpace& space : spaces) {
    GrevilleSpace own = greville_space(space, region);
    const WebExtension web = WebExtension::of_inner(space, own.inner);
    for (const WebExtension::Entry& entry : web.entries())
      entries.emplace_back(rows + entry.function, columns + entry.inner, entry.weight);
    for (const int function : web.inner()) inner_functions.push_back(rows + function);
    rows += space.size();
    columns += web.size();
    points.push_back(std::move(own.points));
  }
  SparseMatrix extension(rows, columns);
  extension.setFromTriplets(entries.begin(), entries.end());
  std::size_t residuals = 0;
  for (const Form& form : forms)
    if (form.place().place == Contribution::Place::volume)
      residuals += form.residual_rows(std::vector<Field>(structures.size(), 0.0)).size();
  if (residuals != spaces.size()) points.resize(1);

  std::vector<Structure> changes;
  for (const Structure& structure : structures) changes.push_back(homogeneous_part(structure));
  ResidualProblem problem;
  problem.size = columns;
  problem.is_linear = std::ranges::all_of(forms, &Form::is_linear);
  problem.at = [&](const Eigen::VectorXd& inner) {
    CollocationSystem system =
        collocate(forms, solution_fields(structures, spaces, extension * inner), changes, spaces,
                  rule, points);
    system.matrix = SparseMatrix(system.matrix * extension);
    return system;
  };
  problem.load = residual_load(forms, structures, spaces, rule, points);
  // The extension continues polynomials, and is the identity on inner functions.
  problem.candidates =
      FreeFunctions(structures, spaces).coefficients()(inner_functions, Eigen::all);
  NewtonSolution solution = solve_residuals(problem, options);
  solution.linear.coefficients = extension * solution.linear.coefficients;
  return solution;
}

}  // namespace rfm
