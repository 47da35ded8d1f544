#include "solvers/kernel.hpp"

#include <algorithm>
#include <cmath>

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
  orthonormalize(basis, weights);
  Eigen::MatrixXd seen(basis.rows(), count);
  for (Eigen::Index k = 0; k < count; ++k)
    seen.col(k) = rows_.cwiseProduct(matrix * columns_.cwiseProduct(basis.col(k)));
  Eigen::MatrixXd turned(count + basis.rows(), count);
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
  weights_.resize(count, static_cast<Eigen::Index>(unseen.size()));
  for (std::size_t k = 0; k < unseen.size(); ++k) {
    weights_.col(static_cast<Eigen::Index>(k)) = turned.col(unseen[k]).head(count);
    functions.col(static_cast<Eigen::Index>(k)) = turned.col(unseen[k]).tail(basis.rows());
  }
  pinned_ = telling_rows(functions);
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
  const Eigen::VectorXd loads = rows_.cwiseProduct(system.right_hand_side);
  const double all = loads.lpNorm<1>();
  if (all == 0) return 0;
  const Eigen::VectorXd missing = system.right_hand_side - whole(system) * solution;
  double largest = 0;
  for (const Eigen::Index i : pinned_) largest = std::max(largest, std::abs(rows_[i] * missing[i]));
  return largest / all;
}

}  // namespace rfm
