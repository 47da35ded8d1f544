#include "solvers/basis_values.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/error.hpp"
#include "core/grid_splines.hpp"
#include "solvers/outer_products.hpp"

namespace rfm {
namespace {

constexpr int highest_derivative = maximum_spline_degree;

// scale · x_i y_j z_k, i running fastest. With the width known at compilation the loops unroll,
// which takes 15% off assembly in space.
template <int width>
void tensor_product(double scale, const double* x, const double* y, int lines_y, const double* z,
                    int lines_z, double* result) {
  for (int k = 0; k < lines_z; ++k)
    for (int j = 0; j < lines_y; ++j, result += width) {
      const double factor = scale * y[j] * z[k];
      for (int i = 0; i < width; ++i) result[i] = factor * x[i];
    }
}
using TensorProduct = decltype(&tensor_product<1>);
constexpr auto tensor_products = []<std::size_t... degree>(std::index_sequence<degree...>) {
  return std::array<TensorProduct, sizeof...(degree)>{&tensor_product<degree + 1>...};
}
(std::make_index_sequence<maximum_spline_degree + 1>());

}  // namespace

BasisValues::BasisValues(std::span<const TensorProductSpace> spaces,
                         std::span<const CompiledIntegrand::BasisDerivative> derivatives)
    : spaces_(spaces), derivatives_(derivatives), order_(spaces.size(), 0) {
  for (const TensorProductSpace& space : spaces)
    padded_.push_back(padded(space.functions_per_cell()));
  for (const auto& [unknown, derivative] : derivatives) {
    double scale = 1;
    for (int axis = 0; axis < 4; ++axis) {
      if (derivative[axis] == 0) continue;
      if (axis >= spaces[unknown].dimension() || derivative[axis] > highest_derivative)
        throw InvalidArgument("splines have no such derivative");
      scale /= std::pow(spaces[unknown].grid().spacing(axis), derivative[axis]);
      order_[unknown] = std::max<int>(order_[unknown], derivative[axis]);
    }
    scale_.push_back(scale);
  }
  values_.resize(derivatives.size());
}

void BasisValues::set_points(int points) {
  points_ = points;
  for (std::size_t m = 0; m < derivatives_.size(); ++m) {
    const std::size_t size = std::size_t(points) * padded_[derivatives_[m].unknown];
    if (values_[m].size() < size) values_[m].resize(size, 0.0);
  }
}

void BasisValues::evaluate(int cell, const IntegrandPoints& points, int first, int last) {
  set_points(last - first);
  const Grid& grid = spaces_[0].grid();
  const std::array<int, 3> position = grid.position(cell);
  std::array<double, 3> low{}, inverse{};
  for (int axis = 0; axis < grid.dimension(); ++axis) {
    low[axis] = grid.line(axis, position[axis]);
    inverse[axis] = 1 / grid.width(axis, position[axis]);
  }
  for (int point = first; point < last; ++point) {
    std::array<double, 3> reference{};
    for (int axis = 0; axis < grid.dimension(); ++axis)
      reference[axis] =
          std::clamp((points.coordinates[axis][point] - low[axis]) * inverse[axis], 0.0, 1.0);
    evaluate_point(point - first, position, reference);
  }
}

void BasisValues::evaluate_reference(std::span<const double> nodes) {
  const int dimension = spaces_[0].dimension(), count = static_cast<int>(nodes.size());
  const int lines_y = dimension > 1 ? count : 1, lines_z = dimension > 2 ? count : 1;
  set_points(count * lines_y * lines_z);
  int point = 0;
  for (int k = 0; k < lines_z; ++k)
    for (int j = 0; j < lines_y; ++j)
      for (int i = 0; i < count; ++i) evaluate_point(point++, {}, {nodes[i], nodes[j], nodes[k]});
}

void BasisValues::evaluate_point(int point, const std::array<int, 3>& cell,
                                 const std::array<double, 3>& reference) {
  double line[3][(highest_derivative + 1) * (maximum_spline_degree + 1)];
  int tabulated = -1;  // the unknown whose splines are in `line`
  for (std::size_t m = 0; m < derivatives_.size(); ++m) {
    const auto& [unknown, derivative] = derivatives_[m];
    const TensorProductSpace& space = spaces_[unknown];
    const int width = space.degree() + 1, dimension = space.dimension();
    if (tabulated != unknown) {
      for (int axis = 0; axis < dimension; ++axis)
        evaluate_bsplines(space.grid(), axis, cell[axis], space.degree(), order_[unknown],
                          reference[axis], line[axis]);
      for (int axis = dimension; axis < 3; ++axis) line[axis][0] = 1;
      tabulated = unknown;
    }
    const double* x = line[0] + derivative[0] * width;
    const double* y = line[1] + derivative[1] * width;
    const double* z = line[2] + derivative[2] * width;
    double* result = values_[m].data() + std::size_t(point) * padded_[unknown];
    tensor_products[space.degree()](scale_[m], x, y, dimension > 1 ? width : 1, z,
                                    dimension > 2 ? width : 1, result);
  }
}

}  // namespace rfm
