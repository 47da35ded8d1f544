#pragma once

#include <Eigen/Core>
#include <memory>

#include "solvers/linear_system.hpp"

namespace rfm {

/// P A Q = L U of a square sparse matrix that need not be symmetric, with threshold pivoting
/// (UMFPACK): equations of weak forms, and saddle points, whose diagonals vanish.
class GeneralFactorization {
 public:
  /// Throws `ComputationError` when a number is not finite or the matrix is singular to working
  /// precision: smallest_singular_value() < 10⁻¹⁴ for entries of size 1. The matrix must outlive
  /// the factorisation, which refines solutions with it.
  explicit GeneralFactorization(const SparseMatrix& matrix);
  ~GeneralFactorization();

  /// With one step of refinement.
  Eigen::VectorXd solve(const Eigen::VectorXd& right_hand_side) const;
  /// The smallest singular value, from above, by two steps of inverse iteration with Aᵀ A.
  double smallest_singular_value() const { return smallest_singular_value_; }

 private:
  Eigen::VectorXd solve(int system, const Eigen::VectorXd& right_hand_side) const;
  const SparseMatrix& matrix_;
  void* numeric_ = nullptr;
  double smallest_singular_value_ = 1;
};

}  // namespace rfm
