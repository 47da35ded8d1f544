#include "basis/tensor_product_space.hpp"

#include <string>

#include "core/bspline.hpp"
#include "core/error.hpp"

namespace rfm {

TensorProductSpace::TensorProductSpace(const Grid& grid, int degree,
                                       std::span<const std::uint8_t> cells)
    : grid_(grid), degree_(degree) {
  if (degree < 1 || degree > maximum_spline_degree)
    throw InvalidArgument("a space of splines has a degree between 1 and " +
                          std::to_string(maximum_spline_degree) + ", got " +
                          std::to_string(degree));
  if (!cells.empty() && cells.size() != std::size_t(grid.cell_count()))
    throw InvalidArgument("a grid of " + std::to_string(grid.cell_count()) + " cells cannot take " +
                          std::to_string(cells.size()) + " flags");
  std::array<int, 3> width{1, 1, 1};
  for (int axis = 0; axis < dimension(); ++axis) {
    splines_[axis] = grid.cells(axis) + degree;
    width[axis] = degree + 1;
  }
  function_of_spline_.assign(spline_count(), -1);
  for (int cell = 0; cell < grid.cell_count(); ++cell) {
    if (!cells.empty() && cells[cell] == 0) continue;
    const std::array<int, 3> low = grid.position(cell);
    for (int k = 0; k < width[2]; ++k)
      for (int j = 0; j < width[1]; ++j)
        for (int i = 0; i < width[0]; ++i)
          function_of_spline_[spline({low[0] + i, low[1] + j, low[2] + k})] = 0;
  }
  for (int spline = 0; spline < spline_count(); ++spline) {
    if (function_of_spline_[spline] < 0) continue;
    function_of_spline_[spline] = size();
    spline_of_function_.push_back(spline);
  }
  if (size() == 0) throw InvalidArgument("no cell of the grid meets the region");
}

std::array<int, 3> TensorProductSpace::place(int spline) const {
  return {spline % splines_[0], spline / splines_[0] % splines_[1],
          spline / (splines_[0] * splines_[1])};
}

int TensorProductSpace::functions_per_cell() const {
  int count = 1;
  for (int axis = 0; axis < dimension(); ++axis) count *= degree_ + 1;
  return count;
}

void TensorProductSpace::cell_functions(int cell, std::span<int> numbers) const {
  const std::array<int, 3> low = grid_.position(cell);
  const int lines_y = dimension() > 1 ? degree_ + 1 : 1,
            lines_z = dimension() > 2 ? degree_ + 1 : 1;
  std::size_t n = 0;
  for (int k = 0; k < lines_z; ++k)
    for (int j = 0; j < lines_y; ++j)
      for (int i = 0; i <= degree_; ++i)
        numbers[n++] = function_of_spline_[spline({low[0] + i, low[1] + j, low[2] + k})];
}

std::vector<double> TensorProductSpace::expand(std::span<const double> coefficients) const {
  if (coefficients.size() != std::size_t(size()))
    throw InvalidArgument("a space of " + std::to_string(size()) + " functions cannot take " +
                          std::to_string(coefficients.size()) + " coefficients");
  std::vector<double> full(spline_count(), 0.0);
  for (int function = 0; function < size(); ++function)
    full[spline_of_function_[function]] = coefficients[function];
  return full;
}

}  // namespace rfm
