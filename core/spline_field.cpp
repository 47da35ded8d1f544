#include "core/spline_field.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "core/bspline.hpp"
#include "core/error.hpp"
#include "core/grid_splines.hpp"
#include "core/multi_index.hpp"

namespace rfm {
namespace {

constexpr int highest_order = maximum_spline_degree;  // along an axis: above, derivatives are zero
constexpr double outside_tolerance = 1e-9;  // of a side: rounding of a point on the boundary

// Place in the jet of each derivative (along z, y, x), with the factor that turns a derivative with
// respect to the reference cell into a Taylor coefficient.
struct JetEntry {
  std::array<int, 3> derivative;
  int place;
  double factor;
};

struct JetPlan {
  std::array<JetEntry, jet_size(3, maximum_order)> entries;
  int count = 0;
};

JetPlan plan_jet(const Grid& grid, int variables, int order, const std::array<int, 3>& highest) {
  JetPlan plan;
  for (int k = 0; k <= highest[2]; ++k)
    for (int j = 0; j <= std::min(highest[1], order - k); ++j)
      for (int i = 0; i <= std::min(highest[0], order - k - j); ++i) {
        const MultiIndex index{std::uint8_t(i), std::uint8_t(j), std::uint8_t(k)};
        double factor = 1 / factorial(index);
        for (int axis = 0; axis < grid.dimension(); ++axis)
          for (int n = 0; n < index[axis]; ++n) factor /= grid.spacing(axis);
        plan.entries[plan.count++] = {{i, j, k}, jet_index(variables, index), factor};
      }
  return plan;
}

}  // namespace

SplineField::SplineField(const Grid& grid, int degree, std::vector<double> coefficients)
    : grid_(grid), degree_(degree), coefficients_(std::move(coefficients)) {
  if (degree < 0 || degree > maximum_spline_degree)
    throw InvalidArgument("the degree of a spline must lie between 0 and 8, got " +
                          std::to_string(degree));
  if (coefficients_.size() != std::size_t(coefficient_count(grid, degree)))
    throw InvalidArgument("a spline of degree " + std::to_string(degree) + " on this grid has " +
                          std::to_string(coefficient_count(grid, degree)) + " coefficients, not " +
                          std::to_string(coefficients_.size()));
  const auto bad =
      std::ranges::find_if_not(coefficients_, [](double c) { return std::isfinite(c); });
  if (bad != coefficients_.end())
    throw InvalidArgument("coefficient " + std::to_string(bad - coefficients_.begin()) +
                          " of a spline is not finite");
  for (int axis = 0; axis < grid.dimension(); ++axis) {
    splines_[axis] = grid.cells(axis) + degree;
    tolerance_[axis] = outside_tolerance * grid.box().length(axis);
  }
}

int SplineField::coefficient_count(const Grid& grid, int degree) {
  int count = 1;
  for (int axis = 0; axis < grid.dimension(); ++axis) count *= grid.cells(axis) + degree;
  return count;
}

template <int degree>
void SplineField::evaluate_degree(const std::array<const double*, 3>& coordinates, int count,
                                  int variables, int order, double* jets, int stride) const {
  constexpr int width = degree + 1;
  const int dimension = grid_.dimension();
  std::array<int, 3> highest{};  // order of derivatives along each axis
  for (int axis = 0; axis < std::min(dimension, variables); ++axis)
    highest[axis] = std::min(order, degree);
  const JetPlan plan = plan_jet(grid_, variables, order, highest);
  if (variables > dimension || order > degree)
    for (int c = 0; c < jet_size(variables, order); ++c)
      std::fill_n(jets + std::ptrdiff_t(c) * stride, count, 0.0);

  const int lines_y = dimension > 1 ? width : 1, lines_z = dimension > 2 ? width : 1;

  double basis[3][(highest_order + 1) * width];
  for (int axis = dimension; axis < 3; ++axis) basis[axis][0] = 1;
  // Contracted with the splines of x (for each derivative), then with those of y too.
  double along_x[highest_order + 1][width * width];
  double along_xy[highest_order + 1][highest_order + 1][width];

  for (int point = 0; point < count; ++point) {
    std::ptrdiff_t first = 0, step = 1;
    bool inside = true;
    for (int axis = 0; axis < dimension; ++axis) {
      const double x = coordinates[axis][point];
      inside = inside && x >= grid_.box().low[axis] - tolerance_[axis] &&
               x <= grid_.box().high[axis] + tolerance_[axis];
      if (!inside) break;
      const int cell = grid_.locate(axis, x);
      const double s = std::clamp((x - grid_.line(axis, cell)) / grid_.width(axis, cell), 0.0, 1.0);
      if (grid_.is_uniform())
        evaluate_bsplines<degree>(s, highest[axis], basis[axis]);
      else
        evaluate_bsplines(grid_, axis, cell, degree, highest[axis], s, basis[axis]);
      first += cell * step;
      step *= splines_[axis];
    }
    if (!inside) {
      for (int c = 0; c < jet_size(variables, order); ++c)
        jets[std::ptrdiff_t(c) * stride + point] = std::numeric_limits<double>::quiet_NaN();
      continue;
    }
    for (int k = 0; k < lines_z; ++k)
      for (int j = 0; j < lines_y; ++j) {
        const double* line = coefficients_.data() + first +
                             std::ptrdiff_t(splines_[0]) * (j + std::ptrdiff_t(splines_[1]) * k);
        for (int a = 0; a <= highest[0]; ++a) {
          double sum = 0;
          for (int i = 0; i < width; ++i) sum += line[i] * basis[0][a * width + i];
          along_x[a][k * width + j] = sum;
        }
      }
    for (int b = 0; b <= highest[1]; ++b)
      for (int a = 0; a <= std::min(highest[0], order - b); ++a)
        for (int k = 0; k < lines_z; ++k) {
          double sum = 0;
          for (int j = 0; j < lines_y; ++j)
            sum += along_x[a][k * width + j] * basis[1][b * width + j];
          along_xy[b][a][k] = sum;
        }
    for (int e = 0; e < plan.count; ++e) {
      const auto& [derivative, place, factor] = plan.entries[e];
      double sum = 0;
      for (int k = 0; k < lines_z; ++k)
        sum += along_xy[derivative[1]][derivative[0]][k] * basis[2][derivative[2] * width + k];
      jets[std::ptrdiff_t(place) * stride + point] = factor * sum;
    }
  }
}

void SplineField::evaluate(const std::array<const double*, 3>& coordinates, int count,
                           int variables, int order, double* jets, int stride) const {
  if (order < 0 || order > maximum_order || variables < 1)
    throw InvalidArgument("jets have orders 0 to " + std::to_string(maximum_order) + ", got " +
                          std::to_string(order));
  const auto run = [&]<int degree>() {
    evaluate_degree<degree>(coordinates, count, variables, order, jets, stride);
  };
  static_assert(maximum_spline_degree == 8);
  switch (degree_) {
    case 0:
      return run.operator()<0>();
    case 1:
      return run.operator()<1>();
    case 2:
      return run.operator()<2>();
    case 3:
      return run.operator()<3>();
    case 4:
      return run.operator()<4>();
    case 5:
      return run.operator()<5>();
    case 6:
      return run.operator()<6>();
    case 7:
      return run.operator()<7>();
    default:
      return run.operator()<8>();
  }
}

std::vector<double> SplineField::breakpoints(int axis) const {
  std::vector<double> lines;
  for (int i = 1; i < (axis < grid_.dimension() ? grid_.cells(axis) : 0); ++i)
    lines.push_back(grid_.line(axis, i));
  return lines;
}

Box SplineField::valid() const { return grid_.box(); }

}  // namespace rfm
