#pragma once

#include <Eigen/Core>

#include "solvers/linear_system.hpp"

namespace rfm {

/// What conjugate gradients came to.
struct ConjugateGradientResult {
  enum class Outcome {
    converged,
    indefinite,  ///< a direction with pᵀ A p ≤ 0 was met: the matrix is not positive definite
    stalled      ///< the limit of iterations was reached
  };
  Outcome outcome = Outcome::stalled;
  Eigen::VectorXd solution;
  int iterations = 0;
  double relative_residual = 1;  ///< by the recurrence
};

/// Solves A x = b for a positive definite matrix of unit diagonal (so that preconditioning by the
/// diagonal is already done), given by its lower triangle, until ‖b − A x‖ ≤ tolerance ‖b‖. Method:
/// M. R. Hestenes and E. Stiefel (1952); about ½ √κ log(2 / tolerance) iterations.
ConjugateGradientResult conjugate_gradient(const SparseMatrix& lower,
                                           const Eigen::VectorXd& right_hand_side, double tolerance,
                                           int largest_iteration_count);

}  // namespace rfm
