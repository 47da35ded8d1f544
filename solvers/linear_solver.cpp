#include "solvers/linear_solver.hpp"

#include <fmt/format.h>
#include <cmath>

#include "core/error.hpp"
#include "solvers/conjugate_gradient.hpp"
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

Eigen::VectorXd solve_directly(const ScaledSystem& system, const LinearSolverOptions& options,
                               LinearSolution& report) {
  const Ordering ordering = options.dimension >= 3 ? Ordering::metis : Ordering::amd;
  const SymmetricFactorization factorization =
      system.elimination_order.empty()
          ? SymmetricFactorization(system.lower, ordering)
          : SymmetricFactorization(system.lower, system.elimination_order);
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

Eigen::VectorXd solve_scaled(const ScaledSystem& system, const LinearSolverOptions& options,
                             LinearSolution& report) {
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

}  // namespace

LinearSolution solve(const LinearSystem& system, const LinearSolverOptions& options) {
  if (!system.right_hand_side.allFinite())
    throw ComputationError("the right-hand side contains a number that is not finite");
  const DiagonalScaling scaling(system.matrix);
  const ScaledSystem scaled{scaling.apply(system.matrix),
                            scaling.factors.cwiseProduct(system.right_hand_side),
                            system.elimination_order};
  // A function without energy that carries a load has no stationary point.
  for (Eigen::Index i = 0; i < system.right_hand_side.size(); ++i)
    if (scaling.factors[i] == 0 && std::abs(system.right_hand_side[i]) > 1e-150)
      throw ComputationError(
          "the system of equations is singular: a part of the solution has a load but no stiffness "
          "(is a coefficient zero there?)");
  LinearSolution result;
  result.dropped = scaling.dropped;
  const Eigen::VectorXd solution = solve_scaled(scaled, options, result);
  result.coefficients = scaling.factors.cwiseProduct(solution);
  if (!result.coefficients.allFinite())
    throw ComputationError("the solution of the system of equations is not finite");
  const double size = scaled.right_hand_side.norm();
  if (size > 0) result.relative_residual = scaled.residual(solution).norm() / size;
  return result;
}

}  // namespace rfm
