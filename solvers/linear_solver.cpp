#include "solvers/linear_solver.hpp"

#include <fmt/format.h>
#include <cmath>

#include "core/error.hpp"
#include "solvers/conjugate_gradient.hpp"
#include "solvers/equilibration.hpp"
#include "solvers/general_factorization.hpp"
#include "solvers/rank_revealing.hpp"
#include "solvers/symmetric_factorization.hpp"

namespace rfm {
namespace {

using Method = LinearSolverOptions::Method;

// S K S y = S f, with c = S y.
struct ScaledSystem {
  SparseMatrix lower;
  Eigen::VectorXd right_hand_side;
  std::span<const std::int64_t> elimination_order;

  Eigen::VectorXd residual(const Eigen::VectorXd& solution) const {
    return right_hand_side - lower.selfadjointView<Eigen::Lower>() * solution;
  }
};

SparseMatrix shifted(SparseMatrix matrix, double shift) {
  for (Eigen::Index i = 0; i < matrix.rows(); ++i) matrix.coeffRef(i, i) += shift;
  matrix.makeCompressed();
  return matrix;
}

Eigen::VectorXd solve_directly(const ScaledSystem& system, const LinearSolverOptions& options,
                               LinearSolution& report) {
  const Ordering ordering = options.dimension >= 3 ? Ordering::metis : Ordering::amd;
  const auto factorized = [&](const SparseMatrix& lower) {
    return system.elimination_order.empty()
               ? SymmetricFactorization(lower, ordering)
               : SymmetricFactorization(lower, system.elimination_order);
  };
  const SymmetricFactorization factorization =
      options.regularization > 0 ? factorized(shifted(system.lower, options.regularization))
                                 : factorized(system.lower);
  report.method = factorization.method() == SymmetricFactorization::Method::cholesky
                      ? LinearSolution::Method::cholesky
                      : LinearSolution::Method::ldlt;
  report.smallest_eigenvalue = factorization.smallest_eigenvalue();
  Eigen::VectorXd solution = factorization.solve(system.right_hand_side);
  for (int step = 0; step < options.refinement_steps; ++step)
    solution += factorization.solve(system.residual(solution));
  return solution;
}

bool tries_conjugate_gradient(const LinearSolverOptions& options, Eigen::Index size) {
  if (options.method != Method::automatic) return options.method == Method::conjugate_gradient;
  return options.dimension >= 3 && size > options.largest_direct_3d;
}

// For systems that may be singular, and are small.
Eigen::VectorXd solve_any_rank(const ScaledSystem& system, const LinearSolverOptions& options,
                               LinearSolution& report) {
  if (system.lower.coeffs().allFinite()) {
    const RankRevealing factorization(system.lower);
    if (factorization.dependent() > 0) {
      report.method = LinearSolution::Method::eigenvectors;
      report.dependent = factorization.dependent();
      report.smallest_eigenvalue = factorization.smallest_kept();
      return factorization.solve(system.right_hand_side);
    }
  }
  return solve_directly(system, options, report);
}

Eigen::VectorXd solve_scaled(const ScaledSystem& system, const LinearSolverOptions& options,
                             LinearSolution& report) {
  if (options.rank_revealing) return solve_any_rank(system, options, report);
  if (!tries_conjugate_gradient(options, system.right_hand_side.size()))
    return solve_directly(system, options, report);
  const ConjugateGradientResult result = conjugate_gradient(
      system.lower, system.right_hand_side, options.tolerance, options.largest_iteration_count);
  report.iterations = result.iterations;
  using Outcome = ConjugateGradientResult::Outcome;
  if (result.outcome == Outcome::converged) {
    report.method = LinearSolution::Method::conjugate_gradient;
    return result.solution;
  }
  if (options.method == Method::automatic) return solve_directly(system, options, report);
  throw ComputationError(
      fmt::format("conjugate gradients {} after {} iterations (relative residual {:.1e}): the "
                  "problem may not determine its solution, or it needs a direct solver",
                  result.outcome == Outcome::indefinite ? "met a direction without positive energy"
                                                        : "did not converge",
                  result.iterations, result.relative_residual));
}

// A function that nothing holds must not carry a load.
void require_no_load(const Eigen::VectorXd& right_hand_side, const Eigen::VectorXd& factors) {
  for (Eigen::Index i = 0; i < right_hand_side.size(); ++i)
    if (factors[i] == 0 && std::abs(right_hand_side[i]) > 1e-150)
      throw ComputationError(
          "the system of equations is singular: a part of the solution has a load but no stiffness "
          "(is a coefficient zero there?)");
}

void require_finite(const Eigen::VectorXd& coefficients) {
  if (!coefficients.allFinite())
    throw ComputationError("the solution of the system of equations is not finite");
}

// Whether a function without energy of its own interacts with others, as the pressure of a saddle
// point does: it must not be dropped.
bool has_saddle(const SparseMatrix& lower, const Eigen::VectorXd& factors) {
  for (Eigen::Index column = 0; column < lower.outerSize(); ++column)
    for (SparseMatrix::InnerIterator entry(lower, column); entry; ++entry)
      if ((factors[column] == 0 || factors[entry.row()] == 0) && std::abs(entry.value()) > 1e-150)
        return true;
  return false;
}

// R K C y = R f, with c = C y.
LinearSolution solve_general(const SparseMatrix& matrix, const Eigen::VectorXd& load,
                             const LinearSolverOptions& options) {
  const Equilibration scaling(matrix);
  require_no_load(load, scaling.rows);
  const SparseMatrix scaled = scaling.apply(matrix);
  const Eigen::VectorXd right_hand_side = scaling.rows.cwiseProduct(load);
  const SparseMatrix factorized =
      options.regularization > 0 ? shifted(scaled, options.regularization) : scaled;
  const GeneralFactorization factorization(factorized);
  Eigen::VectorXd solution = factorization.solve(right_hand_side);
  if (options.regularization > 0)
    for (int step = 0; step < options.refinement_steps; ++step)
      solution += factorization.solve(right_hand_side - scaled * solution);
  LinearSolution result;
  result.method = LinearSolution::Method::lu;
  result.dropped = scaling.dropped;
  result.smallest_eigenvalue = factorization.smallest_singular_value();
  result.coefficients = scaling.columns.cwiseProduct(solution);
  require_finite(result.coefficients);
  const double size = right_hand_side.norm();
  if (size > 0) result.relative_residual = (right_hand_side - scaled * solution).norm() / size;
  return result;
}

}  // namespace

LinearSolution solve(const LinearSystem& system, const LinearSolverOptions& options) {
  if (!system.right_hand_side.allFinite())
    throw ComputationError("the right-hand side contains a number that is not finite");
  if (!system.symmetric) return solve_general(system.matrix, system.right_hand_side, options);
  const DiagonalScaling scaling(system.matrix);
  if (scaling.dropped > 0 && has_saddle(system.matrix, scaling.factors))
    return solve_general(system.matrix.selfadjointView<Eigen::Lower>(), system.right_hand_side,
                         options);
  const ScaledSystem scaled{scaling.apply(system.matrix),
                            scaling.factors.cwiseProduct(system.right_hand_side),
                            system.elimination_order};
  require_no_load(system.right_hand_side, scaling.factors);
  LinearSolution result;
  result.dropped = scaling.dropped;
  const Eigen::VectorXd solution = solve_scaled(scaled, options, result);
  result.coefficients = scaling.factors.cwiseProduct(solution);
  require_finite(result.coefficients);
  const double size = scaled.right_hand_side.norm();
  if (size > 0) result.relative_residual = scaled.residual(solution).norm() / size;
  return result;
}

}  // namespace rfm
