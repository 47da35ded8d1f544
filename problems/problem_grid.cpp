#include "problems/problem_grid.hpp"

#include <algorithm>
#include <cmath>

namespace rfm {
namespace {

// Functions of the whole domain turn about once per cell.
int global_cells(const Discretization& discretization) {
  return std::max(8, discretization.degree);
}

}  // namespace

Grid problem_grid(const Problem& problem, const Box& bounds, std::optional<int> cells) {
  const Discretization& discretization = problem.discretization;
  const Box box = discretization.grid.value_or(bounds);
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

}  // namespace rfm
