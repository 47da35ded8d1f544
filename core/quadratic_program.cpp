#include "core/quadratic_program.hpp"

#include <algorithm>
#include <cmath>

namespace rfm {
namespace {

using Vector = QuadraticModel::Vector<double>;

double product(const Vector& a, const Vector& b, int size) {
  double sum = 0;
  for (int i = 0; i < size; ++i) sum += a[i] * b[i];
  return sum;
}

// Non-negative λ with Gλ − h ≥ 0 and λ·(Gλ − h) = 0.
class Multipliers {
 public:
  Multipliers(std::vector<std::vector<double>> matrix, std::vector<double> right_side)
      : matrix_(std::move(matrix)),
        right_side_(std::move(right_side)),
        values_(right_side_.size()) {}

  std::vector<double> run() {
    const int most_steps = 3 * static_cast<int>(values_.size()) + 3;
    for (int step = 0; step < most_steps && enter(); ++step)
      for (bool dropped = true; dropped;) {
        const std::vector<double> target = solved();
        dropped = approach(target);
      }
    return values_;
  }

 private:
  // The condition that is violated most, in units of its own length.
  bool enter() {
    int worst = -1;
    double most = 1e-13;
    for (int k = 0; k < static_cast<int>(values_.size()); ++k) {
      if (std::find(active_.begin(), active_.end(), k) != active_.end()) continue;
      double rest = right_side_[k], scale = std::fabs(rest);
      for (const int j : active_) {
        rest -= matrix_[k][j] * values_[j];
        scale += std::fabs(matrix_[k][j] * values_[j]);
      }
      if (rest > most * scale) {
        most = rest / scale;
        worst = k;
      }
    }
    if (worst >= 0) active_.push_back(worst);
    return worst >= 0;
  }

  // G λ = h for the active conditions, by elimination. One that depends on the others makes large
  // numbers, which lead to the exchange of one of them for it.
  std::vector<double> solved() const {
    const int n = static_cast<int>(active_.size());
    std::vector<std::vector<double>> a(n, std::vector<double>(n));
    std::vector<double> b(n), x(n);
    for (int i = 0; i < n; ++i) {
      b[i] = right_side_[active_[i]];
      for (int j = 0; j < n; ++j) a[i][j] = matrix_[active_[i]][active_[j]];
    }
    for (int i = 0; i < n; ++i) {
      a[i][i] = std::max(a[i][i], 1e-12 * matrix_[active_[i]][active_[i]]);
      for (int row = i + 1; row < n; ++row) {
        const double factor = a[row][i] / a[i][i];
        for (int j = i; j < n; ++j) a[row][j] -= factor * a[i][j];
        b[row] -= factor * b[i];
      }
    }
    for (int i = n - 1; i >= 0; --i) {
      double sum = b[i];
      for (int j = i + 1; j < n; ++j) sum -= a[i][j] * x[j];
      x[i] = sum / a[i][i];
    }
    return x;
  }

  // As far towards the target as all stay positive; those that reach 0 leave.
  bool approach(const std::vector<double>& target) {
    double part = 1;
    int first = -1;
    for (int i = 0; i < static_cast<int>(active_.size()); ++i) {
      if (target[i] > 0) continue;
      const double now = values_[active_[i]];
      const double until = now > 0 ? now / (now - target[i]) : 0;
      if (until > part) continue;
      part = until;
      first = i;
    }
    for (int i = 0; i < static_cast<int>(active_.size()); ++i) {
      double& value = values_[active_[i]];
      value = std::max(0.0, value + part * (target[i] - value));
    }
    if (first < 0) return false;
    values_[active_[first]] = 0;
    active_.erase(active_.begin() + first);
    return true;
  }

  std::vector<std::vector<double>> matrix_;
  std::vector<double> right_side_, values_;
  std::vector<int> active_;
};

}  // namespace

QuadraticMinimum constrained_minimum(const ShiftedCholesky& cholesky, const Vector& gradient,
                                     int size, const std::vector<LinearCondition>& conditions) {
  const std::size_t count = conditions.size();
  const Vector w = cholesky.forward(gradient);
  std::vector<Vector> rows;  // L⁻¹ times the slopes
  for (const LinearCondition& condition : conditions)
    rows.push_back(cholesky.forward(condition.slope));
  std::vector<std::vector<double>> matrix(count, std::vector<double>(count));
  std::vector<double> right_side(count);
  for (std::size_t i = 0; i < count; ++i) {
    right_side[i] = product(rows[i], w, size) - conditions[i].value;
    for (std::size_t j = 0; j < count; ++j) matrix[i][j] = product(rows[i], rows[j], size);
  }
  QuadraticMinimum minimum;
  minimum.multipliers = Multipliers(std::move(matrix), std::move(right_side)).run();
  Vector force{};
  for (int i = 0; i < size; ++i) {
    force[i] = -gradient[i];
    for (std::size_t k = 0; k < count; ++k)
      force[i] += minimum.multipliers[k] * conditions[k].slope[i];
  }
  minimum.step = cholesky.solve(force);
  return minimum;
}

}  // namespace rfm
