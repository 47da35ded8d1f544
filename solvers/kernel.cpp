#include "solvers/kernel.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/error.hpp"
#include "solvers/equilibration.hpp"

namespace rfm {
namespace {

// ‖A y‖ / ‖y‖ of the scaled matrix, whose entries are 1 at most: what rounding leaves of zero. A
// function that is held, however softly, has more.
constexpr double nothing = 1e-11;
// What quadrature may leave of zero.
constexpr double doubtful = 1e-5;

SparseMatrix whole(const LinearSystem& system) {
  if (!system.symmetric) return system.matrix;
  return SparseMatrix(system.matrix.selfadjointView<Eigen::Lower>());
}

Eigen::MatrixXd without_columns(const Eigen::MatrixXd& matrix,
                                const std::vector<Eigen::Index>& dropped) {
  Eigen::MatrixXd kept(matrix.rows(), matrix.cols() - static_cast<Eigen::Index>(dropped.size()));
  for (Eigen::Index k = 0, next = 0; k < matrix.cols(); ++k)
    if (std::ranges::find(dropped, k) == dropped.end()) kept.col(next++) = matrix.col(k);
  return kept;
}

// The middle of the factors of other functions; 1 where there are none.
double middle_of(const Eigen::VectorXd& factors, const std::vector<Eigen::Index>& except) {
  std::vector<double> others;
  for (Eigen::Index i = 0; i < factors.size(); ++i)
    if (factors[i] > 0 && std::ranges::find(except, i) == except.end())
      others.push_back(factors[i]);
  if (others.empty()) return 1;
  const auto middle = others.begin() + static_cast<std::ptrdiff_t>(others.size() / 2);
  std::nth_element(others.begin(), middle, others.end());
  return *middle;
}

// Turns the columns of A, and those of X alike, until they are orthogonal: the lengths of A's are
// its singular values. One-sided rotations of C. Jacobi (M. R. Hestenes, 1958), as exact for small
// values as for large ones.
void orthogonalize(Eigen::MatrixXd& a, Eigen::MatrixXd& x) {
  const auto turn = [](Eigen::MatrixXd& columns, Eigen::Index i, Eigen::Index j, double c,
                       double s) {
    for (Eigen::Index row = 0; row < columns.rows(); ++row) {
      const double first = columns(row, i), second = columns(row, j);
      columns(row, i) = c * first - s * second;
      columns(row, j) = s * first + c * second;
    }
  };
  bool changed = true;
  for (int sweep = 0; sweep < 30 && changed; ++sweep) {
    changed = false;
    for (Eigen::Index i = 0; i < a.cols(); ++i)
      for (Eigen::Index j = i + 1; j < a.cols(); ++j) {
        const double p = a.col(i).squaredNorm(), q = a.col(j).squaredNorm();
        const double r = a.col(i).dot(a.col(j));
        if (r == 0 || std::abs(r) <= 1e-15 * std::sqrt(p * q)) continue;
        changed = true;
        const double zeta = (q - p) / (2 * r);
        const double t = std::copysign(1 / (std::abs(zeta) + std::hypot(1, zeta)), zeta);
        const double c = 1 / std::hypot(1, t);
        turn(a, i, j, c, c * t);
        turn(x, i, j, c, c * t);
      }
  }
}

// Makes the columns of A orthonormal, turning those of X alike (E. Schmidt's method, twice).
void orthonormalize(Eigen::MatrixXd& a, Eigen::MatrixXd& x) {
  for (Eigen::Index i = 0; i < a.cols(); ++i) {
    for (int twice = 0; twice < 2; ++twice)
      for (Eigen::Index j = 0; j < i; ++j) {
        const double share = a.col(j).dot(a.col(i));
        a.col(i) -= share * a.col(j);
        x.col(i) -= share * x.col(j);
      }
    const double length = a.col(i).norm();
    a.col(i) /= length;
    x.col(i) /= length;
  }
}

// Rows of a few columns that tell these apart best: the largest entry that is left, in turn.
std::vector<Eigen::Index> telling_rows(Eigen::MatrixXd columns) {
  std::vector<Eigen::Index> rows;
  for (Eigen::Index k = 0; k < columns.cols(); ++k) {
    Eigen::Index row = 0, column = 0;
    columns.cwiseAbs().maxCoeff(&row, &column);
    rows.push_back(row);
    const Eigen::VectorXd pivot = columns.col(column) / columns(row, column);
    for (Eigen::Index j = 0; j < columns.cols(); ++j) {
      const double share = columns(row, j);
      columns.col(j) -= share * pivot;
    }
  }
  return rows;
}

}  // namespace

UnbalancedLoads::UnbalancedLoads(Eigen::MatrixXd kernel, double missing)
    : ComputationError(fmt::format(
          "no steady solution exists: nothing fixes a part of it, and the loads on that "
          "do not balance (by {:.1e} of all loads)",
          missing)),
      kernel_(std::move(kernel)),
      missing_(missing) {}

Kernel::Kernel(const LinearSystem& system, const Eigen::MatrixXd& candidates,
               const std::function<LinearSystem()>& finer) {
  if (candidates.rows() != system.size())
    throw InvalidArgument("candidates for a kernel have a coefficient for every unknown");
  const Eigen::Index count = candidates.cols();
  if (count == 0) return;
  const SparseMatrix matrix = whole(system);
  const Equilibration scaling(matrix);
  rows_ = scaling.rows;
  columns_ = scaling.columns;
  Eigen::MatrixXd basis = candidates;  // y of A y = R K c, c = C y; nothing where c is dropped
  for (Eigen::Index i = 0; i < basis.rows(); ++i)
    basis.row(i) *= columns_[i] > 0 ? 1 / columns_[i] : 0;
  Eigen::MatrixXd weights = Eigen::MatrixXd::Identity(count, count);
  // Candidates of functions that are all dropped, or would be but for rounding, which scaling makes
  // as large as any other entry: another rule has another.
  std::optional<SparseMatrix> better;
  const auto is_noise = [&](Eigen::Index function) {
    if (!finer) return false;
    if (!better) better = whole(finer());
    const Eigen::VectorXd own = matrix.col(function);
    return (better->col(function) - own).norm() > 0.5 * own.norm();
  };
  std::vector<Eigen::Index> dropped;
  for (Eigen::Index k = 0; k < count; ++k) {
    Eigen::Index row = 0;
    candidates.col(k).cwiseAbs().maxCoeff(&row);
    const bool is_single = (candidates.col(k).array() != 0).count() == 1;
    if (!basis.col(k).isZero(0) && !(is_single && is_noise(row))) continue;
    dropped.push_back(k);
    pinned_.push_back(row);
  }
  for (Eigen::VectorXd* scale : {&rows_, &columns_}) {
    const double others = middle_of(*scale, pinned_);
    for (const Eigen::Index row : pinned_) (*scale)[row] = others;
  }
  weights_ = Eigen::MatrixXd::Zero(count, static_cast<Eigen::Index>(dropped.size()));
  for (std::size_t k = 0; k < dropped.size(); ++k)
    weights_(dropped[k], static_cast<Eigen::Index>(k)) = 1;
  if (dropped.size() == static_cast<std::size_t>(count)) return;
  basis = without_columns(basis, dropped);
  weights = without_columns(weights, dropped);
  find(matrix, basis, weights, finer);
}

void Kernel::find(const SparseMatrix& matrix, Eigen::MatrixXd& basis, Eigen::MatrixXd& weights,
                  const std::function<LinearSystem()>& finer) {
  const Eigen::Index count = basis.cols();
  orthonormalize(basis, weights);
  Eigen::MatrixXd seen(basis.rows(), count);
  for (Eigen::Index k = 0; k < count; ++k)
    seen.col(k) = rows_.cwiseProduct(matrix * columns_.cwiseProduct(basis.col(k)));
  const Eigen::Index all = weights.rows();
  Eigen::MatrixXd turned(all + basis.rows(), count);
  turned << weights, basis;
  orthogonalize(seen, turned);
  std::vector<Eigen::Index> unseen;
  for (Eigen::Index k = 0; k < count; ++k)
    if (seen.col(k).norm() < nothing) unseen.push_back(k);
  const auto is_doubtful = [&](Eigen::Index k) {
    return seen.col(k).norm() >= nothing && seen.col(k).norm() < doubtful;
  };
  bool any_doubt = false;
  for (Eigen::Index k = 0; k < count; ++k) any_doubt = any_doubt || is_doubtful(k);
  if (any_doubt && finer) {
    const SparseMatrix better = whole(finer());
    for (Eigen::Index k = 0; k < count; ++k) {
      if (!is_doubtful(k)) continue;
      const Eigen::VectorXd function = turned.col(k).tail(basis.rows());
      const double left = rows_.cwiseProduct(better * columns_.cwiseProduct(function)).norm();
      if (left < 0.1 * seen.col(k).norm()) unseen.push_back(k);
    }
  }
  if (unseen.empty()) return;
  Eigen::MatrixXd functions(basis.rows(), unseen.size());
  const Eigen::Index known = weights_.cols();
  weights_.conservativeResize(all, known + static_cast<Eigen::Index>(unseen.size()));
  for (std::size_t k = 0; k < unseen.size(); ++k) {
    weights_.col(known + static_cast<Eigen::Index>(k)) = turned.col(unseen[k]).head(all);
    functions.col(static_cast<Eigen::Index>(k)) = turned.col(unseen[k]).tail(basis.rows());
  }
  for (const Eigen::Index row : telling_rows(functions)) pinned_.push_back(row);
}

LinearSystem Kernel::pinned(LinearSystem system) const {
  if (size() == 0) return system;
  std::vector<bool> is_pinned(system.size(), false);
  for (const Eigen::Index i : pinned_) is_pinned[i] = true;
  for (Eigen::Index column = 0; column < system.matrix.outerSize(); ++column)
    for (SparseMatrix::InnerIterator entry(system.matrix, column); entry; ++entry)
      if (is_pinned[entry.row()] || is_pinned[column]) entry.valueRef() = 0;
  for (const Eigen::Index i : pinned_) {
    system.matrix.coeffRef(i, i) = 1 / (rows_[i] * columns_[i]);
    system.right_hand_side[i] = 0;
  }
  return system;
}

double Kernel::incompatibility(const LinearSystem& system, const Eigen::VectorXd& solution) const {
  if (size() == 0) return 0;
  return imbalance(system.right_hand_side - whole(system) * solution, system.right_hand_side);
}

double Kernel::imbalance(const Eigen::VectorXd& residual, const Eigen::VectorXd& loads) const {
  const double all = size() > 0 ? rows_.cwiseProduct(loads).lpNorm<1>() : 0;
  if (all == 0) return 0;
  double largest = 0;
  for (const Eigen::Index i : pinned_)
    largest = std::max(largest, std::abs(rows_[i] * residual[i]));
  return largest / all;
}

}  // namespace rfm
