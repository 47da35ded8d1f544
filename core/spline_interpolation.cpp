#include "core/spline_interpolation.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "core/diagnosis.hpp"
#include "core/error.hpp"
#include "core/grid_splines.hpp"
#include "core/tape.hpp"

namespace rfm {
namespace {

/// The values of the splines of an axis at its interpolation points, factorised. Row i holds
/// columns i − degree … i + degree. The matrix is totally positive: elimination without pivoting is
/// stable (de Boor and Pinkus 1977).
class Collocation {
 public:
  Collocation(const Grid& grid, int axis, int degree)
      : size_(grid.cells(axis) + degree),
        degree_(degree),
        entries_(std::size_t(size_) * (2 * degree + 1), 0.0) {
    const std::vector<double> points = interpolation_points(grid, axis, degree);
    std::vector<double> splines(std::size_t(degree) + 1);
    for (int i = 0; i < size_; ++i) {
      const int cell = grid.locate(axis, points[i]);
      const double s =
          std::clamp((points[i] - grid.line(axis, cell)) / grid.width(axis, cell), 0.0, 1.0);
      evaluate_bsplines(grid, axis, cell, degree, 0, s, splines.data());
      for (int k = 0; k <= degree; ++k)
        if (splines[k] != 0) at(i, cell + k) = splines[k];
    }
    for (int k = 0; k < size_; ++k)
      for (int i = k + 1; i <= std::min(size_ - 1, k + degree); ++i) {
        const double factor = at(i, k) /= at(k, k);
        for (int j = k + 1; j <= std::min(size_ - 1, k + degree); ++j)
          at(i, j) -= factor * at(k, j);
      }
  }

  // In place, for the numbers at `values`, `stride` apart.
  void solve(double* values, std::ptrdiff_t stride) const {
    for (int i = 0; i < size_; ++i)
      for (int k = std::max(0, i - degree_); k < i; ++k)
        values[i * stride] -= at(i, k) * values[k * stride];
    for (int i = size_ - 1; i >= 0; --i) {
      for (int k = i + 1; k <= std::min(size_ - 1, i + degree_); ++k)
        values[i * stride] -= at(i, k) * values[k * stride];
      values[i * stride] /= at(i, i);
    }
  }

 private:
  double& at(int i, int j) {
    return entries_[std::size_t(i) * (2 * degree_ + 1) + j - i + degree_];
  }
  double at(int i, int j) const {
    return entries_[std::size_t(i) * (2 * degree_ + 1) + j - i + degree_];
  }

  int size_, degree_;
  std::vector<double> entries_;
};

}  // namespace

std::vector<double> interpolation_points(const Grid& grid, int axis, int degree) {
  const int cells = grid.cells(axis);
  std::vector<double> points;
  for (int j = 0; j < cells + degree; ++j) {
    if (degree == 0) {
      points.push_back(0.5 * (grid.line(axis, j) + grid.line(axis, j + 1)));
      continue;
    }
    // The average of knots in units of cells is exact; the ends are the numbers of the grid.
    int sum = 0;
    for (int i = 1; i <= degree; ++i) sum += std::clamp(j - degree + i, 0, cells);
    const double position = double(sum) / degree;
    const int line = std::min(static_cast<int>(position), cells);
    const double rest = position - line;
    points.push_back(rest == 0
                         ? grid.line(axis, line)
                         : (1 - rest) * grid.line(axis, line) + rest * grid.line(axis, line + 1));
  }
  return points;
}

SplineField interpolate(const Grid& grid, int degree, const std::vector<double>& values) {
  // The constructor checks degree and number of values before they are used below.
  const SplineField checked(grid, degree, values);
  for (const double value : values)
    if (!std::isfinite(value))
      throw InvalidArgument("values to interpolate must be finite numbers");
  std::vector<double> coefficients = values;
  std::ptrdiff_t stride = 1;
  for (int axis = 0; axis < grid.dimension(); ++axis) {
    const Collocation matrix(grid, axis, degree);
    const std::ptrdiff_t length = grid.cells(axis) + degree;
    const auto total = static_cast<std::ptrdiff_t>(coefficients.size());
    for (std::ptrdiff_t outer = 0; outer < total; outer += stride * length)
      for (std::ptrdiff_t inner = 0; inner < stride; ++inner)
        matrix.solve(coefficients.data() + outer + inner, stride);
    stride *= length;
  }
  return SplineField(grid, degree, std::move(coefficients));
}

SplineField sample(const Field& field, const Grid& grid, int degree) {
  const int dimension = grid.dimension();
  std::array<std::vector<double>, 3> points{std::vector{0.0}, std::vector{0.0}, std::vector{0.0}};
  for (int axis = 0; axis < dimension; ++axis)
    points[axis] = interpolation_points(grid, axis, degree);
  const Tape tape({field}, {0}, dimension);
  std::vector<double> values;
  for (const double z : points[2])
    for (const double y : points[1])
      for (const double x : points[0]) {
        const Point point{x, y, z};
        values.push_back(tape.value(point));
        if (!std::isfinite(values.back()))
          throw ComputationError("the field to sample is not a finite number at the point " +
                                 point_text(point, dimension) +
                                 diagnosis_suffix(field, point, dimension));
      }
  return interpolate(grid, degree, values);
}

}  // namespace rfm
