#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "solvers/linear_system.hpp"

namespace rfm {

struct EigenOptions {
  int count = 6;     ///< of eigenvalues wanted
  double shift = 0;  ///< those from here on, ascending
  int dimension = 2;
  /// Of the operator: eigenvalues on a grid of n unknowns reach up to about n^(order/dimension)
  /// times the smallest.
  int order = 2;
  /// Relative accuracy of 1/(λ − σ) at which Lanczos' method stops; a step of inverse iteration
  /// after it squares what is left.
  double tolerance = 1e-10;
  /// A good order of elimination for the matrices, if one is known.
  std::vector<std::int64_t> elimination_order{};
};

/// λ and x with K x = λ M x and xᵀ M x = 1.
struct EigenPair {
  double value = 0;
  /// ‖K x − λ M x‖ / ‖(K − σ M) x‖, both sides scaled by the diagonal of K, recomputed from the
  /// matrices as they were given; σ lies a little below the first eigenvalue wanted.
  double residual = 0;
  Eigen::VectorXd vector;
};

struct EigenPairs {
  std::vector<EigenPair> pairs;  ///< ascending, multiple eigenvalues repeated
  /// Eigenvalues that lie from the shift up to `upper`, by the signs of the pivots of K − upper M,
  /// and those of them that were found. They agree, or `eigen_pairs` throws.
  int present = 0, found = 0;
  double upper = 0;
};

/// The `count` smallest eigenvalues λ ≥ shift of K x = λ M x, for symmetric matrices given by their
/// lower triangles, M positive definite.
///
/// Both are scaled by diag(K + |σ| M)^−½ on both sides, and M by an estimate of the smallest
/// eigenvalue, so that units do not matter. Lanczos' method (Spectra) finds the largest
/// eigenvalues 1/(λ − σ) of (K − σ M)⁻¹ M for a σ a little below the shift, so that kernels (rigid
/// motions, constants) do no harm, and K may be indefinite, as Nitsche's method makes it on small
/// cuts. A method that starts from one vector sees a multiple eigenvalue once but for rounding:
/// the count of J. J. Sylvester's law of inertia tells how many there are up to a place in a gap,
/// and Lanczos' method goes on in the complement of what is known until none is missing. One step
/// of inverse iteration with all of them, and W. Ritz's method in their span, end the search.
///
/// Throws `InvalidArgument` if the matrices do not fit or `count` < 1, and `ComputationError` if
/// there are fewer eigenvalues than wanted from the shift on, some are missing, a residual is above
/// 1e-6, M is seen not to be positive, or the matrices are singular together.
EigenPairs eigen_pairs(const SparseMatrix& stiffness, const SparseMatrix& mass,
                       const EigenOptions& options = {});

}  // namespace rfm
