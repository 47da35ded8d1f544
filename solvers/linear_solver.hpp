#pragma once

#include <Eigen/Core>

#include "solvers/linear_system.hpp"

namespace rfm {

struct LinearSolverOptions {
  enum class Method { automatic, direct, conjugate_gradient };
  /// Automatic: a direct factorisation in one and two dimensions; in three, conjugate gradients
  /// from `largest_direct_3d` unknowns on, where factors grow as n^(4/3) (42,875 unknowns of
  /// degree 3: 14 s and 1.3 GB against 3 s and 0.3 GB), and a factorisation again if they fail, as
  /// they do when the matrix is not positive definite.
  Method method = Method::automatic;
  int dimension = 2;
  int largest_direct_3d = 20'000;
  /// Relative residual of the scaled system at which conjugate gradients stop: errors of the
  /// discretisation are larger by orders of magnitude.
  double tolerance = 1e-12;
  /// Scaled systems take some hundred iterations.
  int largest_iteration_count = 3000;
  /// Steps of iterative refinement of a direct solution: the first gains the digits that scaling
  /// and elimination lost, more gain nothing without higher precision.
  int refinement_steps = 1;
  /// Of direct solutions: added to the unit diagonal of the scaled matrix before it is factorised,
  /// while refinement goes on with the matrix itself (iterated regularisation of A. N. Tikhonov).
  /// For structures in which two undetermined functions describe nearly the same, as Ψ1 and ω² Ψ2
  /// do: 10⁻¹² with three steps leaves an energy of 10⁻¹² |c|² at most of what they could do. 0:
  /// a singular system is an error, as it should be where a condition is missing.
  double regularization = 0;
  /// Of direct solutions: a system that is singular to working precision is solved in the span of
  /// its eigenvectors that are not (solvers/rank_revealing.hpp). For functions that depend on each
  /// other by nature, as polynomials of high degree on a part of their box do; of n³ operations.
  bool rank_revealing = false;
};

struct LinearSolution {
  enum class Method { cholesky, ldlt, conjugate_gradient, lu, qr, eigenvectors };
  Eigen::VectorXd coefficients;
  /// ‖f − K c‖ / ‖f‖ in the scaled system; 0 if f = 0.
  double relative_residual = 0;
  /// Splines left out because their diagonal vanished; their coefficients are 0.
  int dropped = 0;
  /// Combinations of functions left out because they vanish to working precision.
  int dependent = 0;
  Method method = Method::cholesky;
  int iterations = 0;  ///< of conjugate gradients
  /// Of the scaled matrix, estimated by direct methods (the smallest singular value of matrices
  /// that are not symmetric): below about 10⁻¹¹ digits are being lost.
  double smallest_eigenvalue = 0;
};

/// K c = f. Of a symmetric K, the stationary point of a quadratic energy, scaled symmetrically by
/// its diagonal; else by a factorisation with pivoting, rows and columns scaled to equal size.
/// Throws `ComputationError` if the system is singular, contains numbers that are not finite, or
/// conjugate gradients were asked for and do not converge.
LinearSolution solve(const LinearSystem& system, const LinearSolverOptions& options = {});

}  // namespace rfm
