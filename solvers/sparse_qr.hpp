#pragma once

#include <Eigen/Core>

#include "solvers/linear_system.hpp"

namespace rfm {

struct LeastSquaresSolution {
  Eigen::VectorXd solution;
  /// Of A with columns of length 1, from above, by two steps of inverse iteration with Rᵀ R.
  double smallest_singular_value = 0;
};

/// The x for which ‖b − A x‖ is least, by a sparse Q R factorisation (SPQR) of A with its columns
/// scaled to length 1: conditioned as A, where normal equations Aᵀ A are as its square. Throws
/// `ComputationError` when A has more columns than rows or its columns depend on each other to
/// working precision.
LeastSquaresSolution least_squares_solution(const SparseMatrix& matrix,
                                            const Eigen::VectorXd& load);

}  // namespace rfm
