#include "core/quadratic_bound.hpp"

#include <algorithm>
#include <cmath>

namespace rfm {

using Vector = QuadraticModel::Vector<double>;
using Matrix = QuadraticModel::Matrix<double>;

ShiftedCholesky::ShiftedCholesky(const Matrix& matrix, int size) : size_(size) {
  double largest = 0;
  for (int i = 0; i < size; ++i)
    for (int j = 0; j <= i; ++j) largest = std::max(largest, std::fabs(matrix[i][j]));
  // Pivots that are rounding errors would make rounding errors of all that follows.
  if (!factorise(matrix))
    for (shift = 1e-14 * largest + 1e-300; std::isfinite(shift) && !factorise(matrix); shift *= 2) {
    }
}

bool ShiftedCholesky::factorise(const Matrix& matrix) {
  for (int i = 0; i < size_; ++i)
    for (int j = 0; j <= i; ++j) {
      double sum = matrix[i][j] + (i == j ? shift : 0);
      for (int k = 0; k < j; ++k) sum -= factor[i][k] * factor[j][k];
      if (i > j) {
        factor[i][j] = sum / factor[j][j];
      } else {
        if (!(sum > 1e-15 * std::fabs(matrix[i][i]))) return false;
        factor[i][i] = std::sqrt(sum);
      }
    }
  return true;
}

Vector ShiftedCholesky::forward(Vector b) const {
  for (int i = 0; i < size_; ++i) {
    for (int k = 0; k < i; ++k) b[i] -= factor[i][k] * b[k];
    b[i] /= factor[i][i];
  }
  return b;
}

Vector ShiftedCholesky::solve(const Vector& b) const {
  Vector x = forward(b);
  for (int i = size_ - 1; i >= 0; --i) {
    for (int k = i + 1; k < size_; ++k) x[i] -= factor[k][i] * x[k];
    x[i] /= factor[i][i];
  }
  return x;
}

namespace {

// g·t + ½|Lᵀt|² ≥ (g − Lw)·t − ½|w|² whatever w, since ½|Lᵀt + w|² ≥ 0: the least over t in a box.
double of_convex_part(const QuadraticModel::Vector<Interval>& gradient,
                      const QuadraticModel::Vector<Interval>& range,
                      const ShiftedCholesky& cholesky, const Vector& w, int size) {
  Interval bound;
  for (int i = 0; i < size; ++i) {
    Interval rest = gradient[i];
    for (int k = 0; k <= i; ++k) rest = rest - Interval(cholesky.factor[i][k]) * Interval(w[k]);
    bound = bound + rest * range[i] - Interval(0.5) * square(Interval(w[i]));
  }
  return bound.low;
}

// −Lᵀt for the lowest t of the box, found by going to the lowest place along one axis after the
// other: any w is good for a bound, this one for a sharp one.
Vector of_lowest(const Vector& slope, const QuadraticModel::Vector<Interval>& range,
                 const ShiftedCholesky& cholesky, int size) {
  constexpr int sweeps = 12;
  const Matrix& factor = cholesky.factor;
  Vector t{}, w{};  // w = −Lᵀt throughout
  for (int sweep = 0; sweep < sweeps; ++sweep)
    for (int i = 0; i < size; ++i) {
      double fall = -slope[i], square = 0;
      for (int k = 0; k <= i; ++k) {
        fall += factor[i][k] * w[k];
        square += factor[i][k] * factor[i][k];
      }
      const double next = std::clamp(t[i] + fall / square, range[i].low, range[i].high);
      if (!std::isfinite(next)) return {};
      for (int k = 0; k <= i; ++k) w[k] -= factor[i][k] * (next - t[i]);
      t[i] = next;
    }
  return w;
}

}  // namespace

double lower_bound(const QuadraticModel& model) {
  const int n = model.size;
  // In variables t = s / extent, within [−1, 1].
  QuadraticModel::Vector<Interval> gradient, range;
  Vector extents{};
  for (int i = 0; i < n; ++i) {
    extents[i] = model.range[i].magnitude();
    range[i] =
        extents[i] > 0 ? intersection(model.range[i] / Interval(extents[i]), {-1, 1}) : Interval();
  }
  QuadraticModel::Matrix<Interval> hessian;
  Vector slope{};
  Matrix least{};
  for (int i = 0; i < n; ++i) {
    const Interval extent(extents[i]);
    gradient[i] = extent * model.gradient[i];
    slope[i] = gradient[i].middle();
    double widths = 0;
    for (int j = 0; j < n; ++j) {
      hessian[i][j] = extent * Interval(extents[j]) * model.hessian[i][j];
      least[i][j] = hessian[i][j].middle();
      widths += hessian[i][j].radius();
    }
    least[i][i] -= widths;
    if (!std::isfinite(widths) || !std::isfinite(slope[i])) return -INFINITY;
  }
  const ShiftedCholesky cholesky(least, n);

  // What H has beyond LLᵀ: tᵀEt ≥ Σ tᵢ² (Eᵢᵢ − Σ |Eᵢⱼ|).
  Interval rest;
  for (int i = 0; i < n; ++i) {
    Interval row;
    for (int j = 0; j < n; ++j) {
      Interval entry = hessian[i][j];
      for (int k = 0; k <= std::min(i, j); ++k)
        entry = entry - Interval(cholesky.factor[i][k]) * Interval(cholesky.factor[j][k]);
      row = row + (i == j ? Interval(entry.low) : Interval(-entry.magnitude()));
    }
    rest = rest + Interval(0.5 * std::min(0.0, row.low));
  }

  const double convex =
      std::max({of_convex_part(gradient, range, cholesky, cholesky.forward(slope), n),
                of_convex_part(gradient, range, cholesky, of_lowest(slope, range, cholesky, n), n),
                of_convex_part(gradient, range, cholesky, {}, n)});
  return (model.value + rest + Interval(convex)).low;
}

}  // namespace rfm
