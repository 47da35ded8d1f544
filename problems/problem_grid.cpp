#include "problems/problem_grid.hpp"

#include <algorithm>
#include <cmath>

namespace rfm {
namespace {

// Functions of the whole domain turn about once per cell.
int global_cells(const Discretization& discretization) {
  return std::max(8, discretization.degree);
}

// Equal cells.
Grid uniform_grid(const Problem& problem, const Box& box, std::optional<int> cells) {
  const Discretization& discretization = problem.discretization;
  if (cells) return Grid::with_square_cells(box, *cells);
  if (discretization.cells.size() == 1)
    return Grid::with_square_cells(box, discretization.cells[0]);
  if (discretization.cells.size() > 1) {
    std::array<int, 3> counts{1, 1, 1};
    std::copy_n(discretization.cells.begin(), problem.dimension, counts.begin());
    return Grid(box, counts);
  }
  if (discretization.basis != Discretization::Basis::bspline)
    return Grid::with_square_cells(box, global_cells(discretization));
  const double size = discretization.cell_size.value_or(box.longest_side() / 64);
  return Grid::with_square_cells(
      box, std::max(1, static_cast<int>(std::ceil(box.longest_side() / size - 1e-9))));
}

std::vector<double> lines_of(const Grid& uniform, int axis, const std::optional<AxisKnots>& knots,
                             bool divided) {
  const double low = uniform.box().low[axis], high = uniform.box().high[axis];
  const int cells = uniform.cells(axis);
  if (!knots) return graded_lines(low, high, cells, {});
  if (knots->lines.empty()) {
    LineGrading grading = knots->grading;
    grading.within = knots->within.value_or(0.25 * (high - low));
    return graded_lines(low, high, cells, grading);
  }
  const double intervals = static_cast<double>(knots->lines.size() - 1);
  return divided_lines(knots->lines,
                       divided ? std::max(1, static_cast<int>(std::lround(cells / intervals))) : 1);
}

}  // namespace

Grid problem_grid(const Problem& problem, const Box& bounds, std::optional<int> cells) {
  const auto& knots = problem.discretization.knots;
  Box box = problem.discretization.grid.value_or(bounds);
  for (int axis = 0; axis < problem.dimension; ++axis)
    if (knots[axis] && !knots[axis]->lines.empty()) {
      box.low[axis] = knots[axis]->lines.front();
      box.high[axis] = knots[axis]->lines.back();
    }
  const Grid uniform = uniform_grid(problem, box, cells);
  if (std::ranges::none_of(knots, [](const auto& axis) { return axis.has_value(); }))
    return uniform;
  std::vector<std::vector<double>> lines;
  for (int axis = 0; axis < problem.dimension; ++axis)
    lines.push_back(lines_of(uniform, axis, knots[axis], cells.has_value()));
  return Grid::with_lines(lines);
}

}  // namespace rfm
