#include "core/grid_splines.hpp"

#include <algorithm>

namespace rfm {
namespace {

constexpr int most = maximum_spline_degree + 1;

// Degrees q − 1 to q of the derivative that is 0 for degrees up to `splines`' own: differences of
// neighbours, each over the length of its support.
void differentiate(const Grid& grid, int axis, int cell, int q, double* values) {
  const auto over_support = [&](int i) {
    return values[i] * q * grid.spacing(axis) /
           (grid.knot(axis, cell + i + 1) - grid.knot(axis, cell + i + 1 - q));
  };
  double right = over_support(q - 1);
  values[q] = right;
  for (int i = q - 1; i >= 1; --i) {
    const double left = over_support(i - 1);
    values[i] = left - right;
    right = left;
  }
  values[0] = -right;
}

}  // namespace

void evaluate_bsplines(const Grid& grid, int axis, int cell, int degree, int order, double s,
                       double* values) {
  if (grid.is_uniform() || degree < 0 || degree > maximum_spline_degree || order < 0)
    return evaluate_bsplines(degree, order, s, values);
  const int count = degree + 1;
  const double width = grid.width(axis, cell), from = grid.knot(axis, cell),
               to = grid.knot(axis, cell + 1);
  // Distances to the knots on either side, sums of positive numbers.
  double left[most], right[most], spline[most] = {1.0};
  for (int q = 0; q <= degree; ++q) {
    if (q > 0) {
      left[q] = s * width + (from - grid.knot(axis, cell + 1 - q));
      right[q] = (1 - s) * width + (grid.knot(axis, cell + q) - to);
      double saved = 0;
      for (int r = 0; r < q; ++r) {
        const double share = spline[r] / (right[r + 1] + left[q - r]);
        spline[r] = saved + right[r + 1] * share;
        saved = left[q - r] * share;
      }
      spline[q] = saved;
    }
    const int k = degree - q;
    if (k > order) continue;
    double* derivative = values + k * count;
    std::copy_n(spline, q + 1, derivative);
    for (int r = q + 1; r <= degree; ++r) differentiate(grid, axis, cell, r, derivative);
  }
  for (int k = count; k <= order; ++k) std::fill_n(values + k * count, count, 0.0);
}

double greville_point(const Grid& grid, int axis, int degree, int spline) {
  if (degree == 0) return 0.5 * (grid.knot(axis, spline) + grid.knot(axis, spline + 1));
  double sum = 0;
  for (int i = 1; i <= degree; ++i) sum += grid.knot(axis, spline - degree + i);
  return sum / degree;
}

BlossomMatrix bernstein_from_bsplines(const Grid& grid, int axis, int cell, int degree, double low,
                                      double high) {
  if (grid.is_uniform()) return bernstein_from_bsplines(degree, low, high);
  const double width = grid.width(axis, cell), from = grid.knot(axis, cell);
  const auto knot = [&](int j) { return (grid.knot(axis, cell + 1 - degree + j) - from) / width; };
  BlossomMatrix matrix{};
  for (int k = 0; k <= degree; ++k) {
    // De Boor's algorithm as for equal cells, with weights by the distances of knots.
    BlossomMatrix points{};
    for (int i = 0; i <= degree; ++i) points[i][i] = 1;
    for (int r = 1; r <= degree; ++r) {
      const double t = r <= degree - k ? low : high;
      for (int i = degree; i >= r; --i) {
        const double before = knot(i - 1), behind = knot(i - r + degree);
        const double weight = (t - before) / (behind - before);
        const double other = (behind - t) / (behind - before);
        for (int c = 0; c <= degree; ++c)
          points[i][c] = other * points[i - 1][c] + weight * points[i][c];
      }
    }
    matrix[k] = points[degree];
  }
  return matrix;
}

BlossomMatrix derivative_coefficients(const Grid& grid, int axis, int cell, int degree) {
  BlossomMatrix matrix{};
  for (int i = 0; i < degree; ++i) {
    const double scale =
        grid.is_uniform()
            ? 1 / grid.spacing(axis)
            : degree / (grid.knot(axis, cell + i + 1) - grid.knot(axis, cell + i + 1 - degree));
    matrix[i][i] = -scale;
    matrix[i][i + 1] = scale;
  }
  return matrix;
}

}  // namespace rfm
