// Linear systems of a problem: how each is solved, and what the equations leave free.

#include <fmt/format.h>

#include "core/error.hpp"
#include "problems/pinned_constant.hpp"
#include "problems/problem_forms.hpp"
#include "problems/scalar_problem.hpp"
#include "problems/stopwatch.hpp"
#include "solvers/assembly.hpp"
#include "solvers/extension.hpp"
#include "solvers/free_functions.hpp"
#include "solvers/kernel.hpp"
#include "solvers/symmetric_factorization.hpp"

namespace rfm {
namespace {

// What the equations leave free, as the level of a pressure or rigid motions, is pinned somehow.
LinearSolution solve_beside_kernel(const LinearSystem& system, const FreeFunctions& candidates,
                                   const std::vector<std::string>& unknowns,
                                   const LinearSolverOptions& options,
                                   const std::function<LinearSystem()>& finer) {
  const Kernel kernel(system, candidates.coefficients(), finer);
  LinearSolution solution = rfm::solve(kernel.pinned(system), options);
  // Quadrature keeps the balance of loads to its own error, which is that of the solution.
  const double missing = kernel.incompatibility(system, solution.coefficients);
  if (!(missing < 1e-6))
    throw ComputationError(
        fmt::format("no steady solution exists: nothing fixes {}, and the loads on it do not "
                    "balance (by {:.1e} "
                    "of all loads)",
                    candidates.text(kernel.weights(), unknowns), missing));
  return solution;
}

// In the splines inside the domain, to which the others are attached.
LinearSolution solve_extended(const LinearSystem& system,
                              const std::vector<TensorProductSpace>& functions,
                              const DomainRule& rule, const LinearSolverOptions& options) {
  const SplineExtension extension(functions, rule);
  LinearSolution solution = rfm::solve(extension.extended(system), options);
  solution.coefficients = extension.matrix * solution.coefficients;
  return solution;
}

}  // namespace

LinearSolverOptions ScalarProblem::linear_options() const {
  LinearSolverOptions options;
  options.dimension = problem_.dimension;
  options.tolerance = problem_.discretization.tolerance;
  if (problem_.discretization.linear_solver == Discretization::LinearSolver::direct)
    options.method = LinearSolverOptions::Method::direct;
  // Several functions in one unknown may describe nearly the same.
  if (function_count() > unknown_count()) {
    options.method = LinearSolverOptions::Method::direct;
    options.regularization = 1e-13;
    options.refinement_steps = 4;
  }
  return options;
}

// Splines of which a few thin slivers are left may be dependent to rounding, so that the matrix is
// singular although the solution is determined: then what a regularised system leaves open is
// nothing inside the domain. Where a condition is missing it is not.
LinearSolution ScalarProblem::solve_determined(const LinearSystem& system,
                                               const std::vector<TensorProductSpace>& functions,
                                               ScalarSolution& solution) const {
  LinearSolverOptions options = linear_options();
  try {
    return rfm::solve(system, options);
  } catch (const SingularSystem&) {
    options.method = LinearSolverOptions::Method::direct;
    options.regularization = 1e-13;
    options.refinement_steps = 4;
    solution.linear = rfm::solve(system, options);
    solution.undetermined = undetermined_part(system, functions, solution, options);
    if (!(*solution.undetermined < 1e-6)) throw;
    return solution.linear;
  }
}

LinearSystem ScalarProblem::solve_linear(const std::vector<Contribution>& parts,
                                         const std::vector<TensorProductSpace>& functions,
                                         bool free_constant, ScalarSolution& solution) const {
  Stopwatch assembly;
  LinearSystem system = assemble(structures(solution.rule.grid()), functions, parts, solution.rule);
  if (free_constant) pin_one(system);
  solution.seconds.assembly = assembly.seconds();
  Stopwatch solve;
  solution.linear =
      problem_.discretization.extension
          ? solve_extended(system, functions, solution.rule, linear_options())
      : free_constant || !uses_forms(*this)
          ? solve_determined(system, functions, solution)
          : solve_beside_kernel(system, FreeFunctions(structures(solution.rule.grid()), functions),
                                problem_.physics.unknowns, linear_options(), [&] {
                                  return assemble(structures(solution.rule.grid()), functions,
                                                  parts, finer_rule(solution.rule.grid()));
                                });
  if (function_count() > unknown_count() && !problem_.discretization.extension)
    solution.undetermined = undetermined_part(system, functions, solution, linear_options());
  solution.seconds.solve = solve.seconds();
  return system;
}

}  // namespace rfm
