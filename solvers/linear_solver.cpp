#include "solvers/linear_solver.hpp"

#include <fmt/format.h>

#include <Eigen/IterativeLinearSolvers>

#include "core/error.hpp"
#include "solvers/symmetric_factorization.hpp"

namespace rfm {
namespace {

Eigen::VectorXd residual(const SparseMatrix& lower, const Eigen::VectorXd& right_hand_side,
                         const Eigen::VectorXd& solution) {
  return right_hand_side - lower.selfadjointView<Eigen::Lower>() * solution;
}

bool use_conjugate_gradient(const LinearSolverOptions& options, Eigen::Index size) {
  using Method = LinearSolverOptions::Method;
  if (options.method != Method::automatic) return options.method == Method::conjugate_gradient;
  return options.dimension >= 3 && size > options.largest_direct_3d;
}

Eigen::VectorXd solve_directly(const SparseMatrix& scaled, const Eigen::VectorXd& right_hand_side,
                               std::span<const std::int64_t> order,
                               const LinearSolverOptions& options, LinearSolution& report) {
  const Ordering ordering = options.dimension >= 3 ? Ordering::metis : Ordering::amd;
  const SymmetricFactorization factorization = order.empty()
                                                   ? SymmetricFactorization(scaled, ordering)
                                                   : SymmetricFactorization(scaled, order);
  report.method = factorization.method() == SymmetricFactorization::Method::cholesky
                      ? LinearSolution::Method::cholesky
                      : LinearSolution::Method::ldlt;
  report.smallest_eigenvalue = factorization.smallest_eigenvalue();
  Eigen::VectorXd solution = factorization.solve(right_hand_side);
  for (int step = 0; step < options.refinement_steps; ++step)
    solution += factorization.solve(residual(scaled, right_hand_side, solution));
  return solution;
}

Eigen::VectorXd solve_by_conjugate_gradient(const SparseMatrix& scaled,
                                            const Eigen::VectorXd& right_hand_side,
                                            const LinearSolverOptions& options,
                                            LinearSolution& report) {
  // The diagonal of the scaled matrix is one: Jacobi preconditioning is already done.
  Eigen::ConjugateGradient<SparseMatrix, Eigen::Lower, Eigen::IdentityPreconditioner> iteration;
  iteration.setTolerance(options.tolerance);
  iteration.setMaxIterations(options.largest_iteration_count);
  iteration.compute(scaled);
  Eigen::VectorXd solution = iteration.solve(right_hand_side);
  report.method = LinearSolution::Method::conjugate_gradient;
  report.iterations = static_cast<int>(iteration.iterations());
  if (iteration.info() != Eigen::Success)
    throw ComputationError(
        fmt::format("conjugate gradients did not converge in {} iterations (relative residual "
                    "{:.1e}): the problem may not determine its solution, or it needs a direct "
                    "solver",
                    options.largest_iteration_count, iteration.error()));
  return solution;
}

}  // namespace

LinearSolution solve(const LinearSystem& system, const LinearSolverOptions& options) {
  if (!system.right_hand_side.allFinite())
    throw ComputationError("the right-hand side contains a number that is not finite");
  const DiagonalScaling scaling(system.matrix);
  const SparseMatrix scaled = scaling.apply(system.matrix);
  const Eigen::VectorXd right_hand_side = scaling.factors.cwiseProduct(system.right_hand_side);

  LinearSolution result;
  result.dropped = scaling.dropped;
  const Eigen::VectorXd solution = use_conjugate_gradient(options, system.size())
                 ? solve_by_conjugate_gradient(scaled, right_hand_side, options, result)
                 : solve_directly(scaled, right_hand_side, system.elimination_order, options, result);
  result.coefficients = scaling.factors.cwiseProduct(solution);
  if (!result.coefficients.allFinite())
    throw ComputationError("the solution of the system of equations is not finite");
  const double size = right_hand_side.norm();
  if (size > 0) result.relative_residual = residual(scaled, right_hand_side, solution).norm() / size;
  return result;
}

}  // namespace rfm
