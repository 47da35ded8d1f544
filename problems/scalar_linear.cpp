// Linear systems of a problem: how each is solved, and what the equations leave free.

#include <fmt/format.h>

#include <algorithm>

#include "core/error.hpp"
#include "problems/pinned_constant.hpp"
#include "problems/problem_forms.hpp"
#include "problems/scalar_problem.hpp"
#include "problems/stopwatch.hpp"
#include "solvers/assembly.hpp"
#include "solvers/block_solve.hpp"
#include "solvers/extension.hpp"
#include "solvers/free_functions.hpp"
#include "solvers/kernel.hpp"
#include "solvers/periodic_splines.hpp"
#include "solvers/refined_splines.hpp"
#include "solvers/symmetric_factorization.hpp"

namespace rfm {
namespace {

// What the equations leave free, as the level of a pressure or rigid motions, is pinned somehow.
// The candidates are those of the functions whose coefficients the system is for.
LinearSolution solve_beside_kernel(const LinearSystem& system, const FreeFunctions& candidates,
                                   const Eigen::MatrixXd& coefficients,
                                   const std::vector<std::string>& unknowns,
                                   const LinearSolverOptions& options,
                                   const std::function<LinearSystem()>& finer) {
  const Kernel kernel(system, coefficients, finer);
  LinearSolution solution = rfm::solve(kernel.pinned(system), options);
  const double missing = kernel.incompatibility(system, solution.coefficients);
  if (!(missing < Kernel::largest_imbalance))
    throw ComputationError(candidates.text(UnbalancedLoads(kernel.weights(), missing), unknowns));
  return solution;
}

// Equations that cancel, as of u^2 - u*u, are no equations: their unknown would be what it is at
// the start.
void require_equations(const Problem& problem, const LinearSystem& system,
                       const std::vector<TensorProductSpace>& functions) {
  std::vector<bool> is_touched(static_cast<std::size_t>(system.size()), false);
  for (Eigen::Index column = 0; column < system.matrix.outerSize(); ++column)
    for (SparseMatrix::InnerIterator entry(system.matrix, column); entry; ++entry)
      if (entry.value() != 0)
        is_touched[static_cast<std::size_t>(entry.row())] =
            is_touched[static_cast<std::size_t>(column)] = true;
  auto own = is_touched.begin();
  for (std::size_t c = 0; c < problem.physics.unknowns.size(); ++c) {
    const auto end = own + functions[c].size();
    if (std::find(own, end, true) == end)
      throw ProblemFileErrors({Mistake{
          fmt::format(
              "the equations determine nothing of '{}': what they hold of it cancels, or is a "
              "load without a stiffness",
              problem.physics.unknowns[c]),
          problem.physics.custom->place}});
    own = end;
  }
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

std::optional<SplineExtraction> ScalarProblem::extraction(
    const std::vector<TensorProductSpace>& functions, const DomainRule& rule,
    const Grid& grid) const {
  if (!windows_.empty()) return refined_splines(own_spaces(rule, grid), functions);
  if (problem_.discretization.extension) return SplineExtension(functions, rule);
  if (!periodic_.empty()) return periodic_splines(functions, periodic_axes(periodic_));
  return std::nullopt;
}

LinearSystem ScalarProblem::solve_linear(const std::vector<Contribution>& parts,
                                         const std::vector<TensorProductSpace>& functions,
                                         bool free_constant, ScalarSolution& solution) const {
  Stopwatch assembly;
  const std::vector<Structure> structures = this->structures(solution.rule.grid());
  LinearSystem system = assemble(structures, functions, parts, solution.rule);
  if (problem_.physics.custom) require_equations(problem_, system, functions);
  solution.seconds.assembly = assembly.seconds();
  Stopwatch solve;
  const std::optional<SplineExtraction> extraction =
      this->extraction(functions, solution.rule, solution.grid);
  std::optional<LinearSystem> folded;
  if (extraction) folded = extraction->folded(system);
  LinearSystem& solved = folded ? *folded : system;
  if (free_constant) pin_one(solved, extraction ? extraction->first[1] : functions[0].size());
  if (!free_constant && uses_forms(*this)) {
    const FreeFunctions candidates(structures, functions);
    solution.linear = solve_beside_kernel(
        solved, candidates,
        extraction ? extraction->reduced(candidates.coefficients()) : candidates.coefficients(),
        problem_.physics.unknowns, linear_options(), [&] {
          const LinearSystem finer =
              assemble(structures, functions, parts, finer_rule(solution.grid));
          return extraction ? extraction->folded(finer) : finer;
        });
  } else if (extraction && solves_in_turn()) {
    solution.linear = solve_in_turn(solved, blocks(*extraction), linear_options());
  } else if (extraction) {
    solution.linear = rfm::solve(solved, linear_options());
  } else {
    solution.linear = solve_determined(solved, functions, solution);
  }
  if (function_count() > unknown_count() && !solves_in_turn())
    solution.undetermined = undetermined_part(solved, functions, solution, linear_options(),
                                              extraction ? &*extraction : nullptr);
  if (extraction) solution.linear.coefficients = extraction->matrix * solution.linear.coefficients;
  solution.seconds.solve = solve.seconds();
  return system;
}

}  // namespace rfm
