#pragma once

#include <Eigen/Core>

#include "solvers/linear_system.hpp"

namespace rfm {

/// A symmetric matrix K, given by its lower triangle, with more functions than are independent to
/// working precision: of K = V Λ Vᵀ only eigenvalues of sizes above n ε times the largest are kept,
/// and
///
///     x = Σ_kept v (vᵀ f) / λ
///
/// is the solution in their span, so that coefficients stay small. What is left out changes an
/// energy by n ε |c|², c the coefficients of the best approximation (B. Adcock, D. Huybrechs,
/// Frames and numerical approximation, SIAM Rev. 61, 2019). Dense: n³ operations.
class RankRevealing {
 public:
  explicit RankRevealing(const SparseMatrix& lower);

  /// How many eigenvectors were left out.
  int dependent() const { return dependent_; }
  /// The smallest size of an eigenvalue that was kept.
  double smallest_kept() const { return smallest_kept_; }
  Eigen::VectorXd solve(const Eigen::VectorXd& load) const;

 private:
  Eigen::VectorXd values_;  // infinite where left out
  Eigen::MatrixXd vectors_;
  int dependent_ = 0;
  double smallest_kept_ = 0;
};

}  // namespace rfm
