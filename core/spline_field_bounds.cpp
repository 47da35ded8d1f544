#include <algorithm>
#include <cmath>
#include <vector>

#include "core/grid_splines.hpp"
#include "core/spline_field.hpp"

namespace rfm {
namespace {

// A tensor of coefficients of one cell, contracted with a matrix along one axis.
void contract(std::vector<double>& tensor, std::array<int, 3>& size, int axis, int rows,
              const BlossomMatrix& matrix) {
  std::array<int, 3> new_size = size;
  new_size[axis] = rows;
  std::vector<double> result(static_cast<std::size_t>(new_size[0] * new_size[1] * new_size[2]));
  const int stride = axis == 0 ? 1 : axis == 1 ? size[0] : size[0] * size[1];
  std::size_t place = 0;
  for (int k = 0; k < new_size[2]; ++k)
    for (int j = 0; j < new_size[1]; ++j)
      for (int i = 0; i < new_size[0]; ++i) {
        std::array<int, 3> at{i, j, k};
        const int row = at[axis];
        at[axis] = 0;
        const int start = at[0] + size[0] * (at[1] + size[1] * at[2]);
        double sum = 0;
        for (int c = 0; c < size[axis]; ++c) sum += matrix[row][c] * tensor[start + c * stride];
        result[place++] = sum;
      }
  tensor = std::move(result);
  size = new_size;
}

Interval hull_of(const std::vector<double>& values, double margin) {
  const auto [low, high] = std::minmax_element(values.begin(), values.end());
  return {*low - margin, *high + margin};
}

}  // namespace

FunctionBounds SplineField::cell_bounds(const std::array<int, 3>& cell, const Box& box) const {
  const int dimension = grid_.dimension();
  std::array<int, 3> size{1, 1, 1};
  std::array<BlossomMatrix, 3> value_matrix, slope_matrix;
  for (int axis = 0; axis < dimension; ++axis) {
    size[axis] = degree_ + 1;
    const double corner = grid_.line(axis, cell[axis]), width = grid_.width(axis, cell[axis]);
    // The reference coordinate of a point is rounded too: widen by what that may cost.
    const double slack = 4e-16 * (std::abs(corner) / width + 1);
    const double low = (box.low[axis] - corner) / width - slack;
    const double high = (box.high[axis] - corner) / width + slack;
    const double from = std::clamp(low, 0.0, 1.0), to = std::clamp(high, 0.0, 1.0);
    value_matrix[axis] = bernstein_from_bsplines(grid_, axis, cell[axis], degree_, from, to);
    if (degree_ > 0)
      slope_matrix[axis] = bernstein_from_bsplines(grid_, axis, cell[axis], degree_ - 1, from, to);
  }
  std::vector<double> local;
  double magnitude = 0;
  for (int k = 0; k < size[2]; ++k)
    for (int j = 0; j < size[1]; ++j)
      for (int i = 0; i < size[0]; ++i) {
        local.push_back(
            coefficients_[cell[0] + i +
                          std::size_t(splines_[0]) *
                              (cell[1] + j + std::size_t(splines_[1]) * (cell[2] + k))]);
        magnitude = std::max(magnitude, std::abs(local.back()));
      }
  // Convex combinations: three per axis and degree, each with two roundings, here and in
  // `evaluate`.
  const double margin = 2e-16 * (12 * degree_ + 12) * magnitude;

  FunctionBounds result;
  std::vector<double> tensor = local;
  std::array<int, 3> shape = size;
  for (int axis = 0; axis < dimension; ++axis)
    contract(tensor, shape, axis, degree_ + 1, value_matrix[axis]);
  result.value = hull_of(tensor, margin);
  for (int slope = 0; slope < dimension && degree_ > 0; ++slope) {
    tensor = local;
    shape = size;
    const BlossomMatrix differences = derivative_coefficients(grid_, slope, cell[slope], degree_);
    contract(tensor, shape, slope, degree_, differences);
    for (int axis = 0; axis < dimension; ++axis)
      contract(tensor, shape, axis, shape[axis],
               axis == slope ? slope_matrix[axis] : value_matrix[axis]);
    double steepest = 0;
    for (int i = 0; i < degree_; ++i) steepest = std::max(steepest, differences[i][i + 1]);
    result.gradient[slope] = hull_of(tensor, 2 * margin * steepest);
  }
  return result;
}

FunctionBounds SplineField::bounds(const Box& box) const {
  const int dimension = grid_.dimension();
  FunctionBounds result;
  std::array<int, 3> first{}, last{};
  int cells = 1;
  bool inside = true;
  for (int axis = 0; axis < dimension; ++axis) {
    inside = inside && box.low[axis] >= grid_.box().low[axis] - tolerance_[axis] &&
             box.high[axis] <= grid_.box().high[axis] + tolerance_[axis];
    first[axis] = grid_.locate(axis, box.low[axis]);
    last[axis] = grid_.locate(axis, box.high[axis]);
    // A box that ends on a grid line does not reach into the cell above, up to continuity.
    if (degree_ > 1 && last[axis] > first[axis] && box.high[axis] == grid_.line(axis, last[axis]))
      --last[axis];
    cells *= last[axis] - first[axis] + 1;
  }
  if (!inside) {
    result.value = Interval::entire();
    for (int axis = 0; axis < dimension; ++axis) result.gradient[axis] = Interval::entire();
    result.smooth = false;
    return result;
  }
  bool begun = false;
  for (int k = first[2]; k <= last[2]; ++k)
    for (int j = first[1]; j <= last[1]; ++j)
      for (int i = first[0]; i <= last[0]; ++i) {
        const FunctionBounds cell = cell_bounds({i, j, k}, box);
        result.value = begun ? hull(result.value, cell.value) : cell.value;
        for (int axis = 0; axis < dimension; ++axis)
          result.gradient[axis] =
              begun ? hull(result.gradient[axis], cell.gradient[axis]) : cell.gradient[axis];
        begun = true;
      }
  result.smooth = degree_ > 1 || cells == 1;
  return result;
}

}  // namespace rfm
