// Equations that are not linear, or hold at points, and the stops on the way to them.

#include <fmt/format.h>

#include <cmath>

#include "core/error.hpp"
#include "problems/continuation.hpp"
#include "problems/problem_forms.hpp"
#include "problems/scalar_problem.hpp"
#include "problems/stopwatch.hpp"
#include "solvers/collocation.hpp"
#include "solvers/equations.hpp"
#include "solvers/free_functions.hpp"
#include "solvers/greville_collocation.hpp"
#include "solvers/kernel.hpp"
#include "solvers/solution.hpp"
#include "solvers/symmetric_factorization.hpp"

namespace rfm {
namespace {

// The coefficients at a stop of a continuation, from those at the one before.
Eigen::VectorXd solved_stop(const ContinuationStop& stop,
                            const std::vector<TensorProductSpace>& functions,
                            const DomainRule& rule, const Grid& grid,
                            const LinearSolverOptions& linear, const NewtonOptions& options,
                            const std::optional<Eigen::VectorXd>& start) {
  const ScalarProblem problem(stop.problem);
  if (std::abs(problem.rule(grid).measure() - rule.measure()) > 1e-9 * rule.measure())
    throw ComputationError(stop.name + ": continuation needs the same domain at all values");
  try {
    return solve_newton(problem.structures(rule.grid()), functions,
                        problem_forms(problem, rule.grid()), rule, linear, options, start)
        .linear.coefficients;
  } catch (const ComputationError& error) {
    throw ComputationError("at " + stop.name + ": " + error.what());
  }
}

// As many equations as unknowns hold, whatever the solution is between the points.
void note_residual_between_points(const std::vector<Structure>& structures,
                                  const std::vector<TensorProductSpace>& functions,
                                  const std::vector<Form>& equations, const NewtonSolution& found,
                                  ScalarSolution& solution) {
  constexpr double much = 0.1;
  std::vector<Structure> changes;
  for (const Structure& structure : structures) changes.push_back(homogeneous_part(structure));
  const auto size_at = [&](const std::vector<Field>& components) {
    return collocate(equations, components, changes, functions, solution.rule)
        .right_hand_side.norm();
  };
  const double residual =
      size_at(solution_fields(structures, functions, found.linear.coefficients));
  const double load = size_at(solution_fields(
      structures, functions, Eigen::VectorXd::Zero(found.linear.coefficients.size())));
  if (residual > much * load)
    solution.notes.push_back(
        fmt::format("warning: between the points of collocation the residuals are {:.2g} of the "
                    "loads: a finer grid, a lower degree or Gauss points (solver.points) may help",
                    residual / load));
}

}  // namespace

bool ScalarProblem::must_use_qr() const {
  return problem_.discretization.method == Discretization::Method::least_squares &&
         problem_.discretization.factorization == Discretization::Factorization::qr;
}

// Where something is free, or two functions describe nearly the same, residuals do not determine
// the coefficients.
bool ScalarProblem::may_use_qr() const {
  return problem_.discretization.method == Discretization::Method::least_squares &&
         problem_.discretization.factorization == Discretization::Factorization::automatic &&
         function_count() == unknown_count() && !fixed_up_to_constant() &&
         !problem_.discretization.continuation && problem_.discretization.load_steps == 1 &&
         !problem_.discretization.extension && periodic_.empty();
}

void ScalarProblem::solve_at_points(const std::vector<Form>& equations,
                                    const std::vector<TensorProductSpace>& functions,
                                    ScalarSolution& solution) const {
  Stopwatch solve;
  const Discretization& discretization = problem_.discretization;
  if (discretization.continuation)
    throw ComputationError("residuals at points are solved without continuation");
  const Grid& grid = solution.rule.grid();
  const std::vector<Structure> structures = this->structures(grid);
  const bool squares = discretization.method == Discretization::Method::least_squares;
  NewtonOptions options;
  options.looks_linear = solution.linearity == Linearity::by_value;
  NewtonSolution newton;
  if (squares) {
    newton = solve_collocation(structures, functions, equations, solution.rule, options);
  } else if (discretization.points == Discretization::Points::gauss) {
    try {
      newton = solve_collocation(structures, functions, equations, collocation_rule(grid), options);
    } catch (const SingularSystem&) {
      if (function_count() == unknown_count()) throw;
      throw ComputationError(
          "functions of the structure describe the same u at the points of collocation, which do "
          "not tell them apart: ritz, galerkin and least squares do without");
    }
  } else {
    if (function_count() > unknown_count())
      throw ComputationError(
          "collocation at Greville points has one equation for each spline of an unknown, but the "
          "structure has more functions than unknowns: enforce conditions weakly (enforce: weak), "
          "or take Gauss points");
    newton = solve_greville(structures, functions, equations, region_, solution.rule, options);
    note_residual_between_points(structures, functions, equations, newton, solution);
  }
  if (!newton.iterations.empty()) solution.linearity = Linearity::none;
  solution.newton_order = newton.order();
  solution.newton = std::move(newton.iterations);
  solution.linear = std::move(newton.linear);
  solution.free_at_points = std::move(newton.free);
  constexpr double much = 0.1;
  if (solution.free_at_points.cols() > 0 && newton.remainder > much)
    solution.notes.push_back(fmt::format(
        "warning: nothing fixes {}, and {:.2g} of the residuals remain: perhaps the loads on it do "
        "not balance, and there is no solution",
        FreeFunctions(structures, functions)
            .text(solution.free_at_points, problem_.physics.unknowns),
        newton.remainder));
  solution.seconds.solve += solve.seconds();
}

bool ScalarProblem::solve_least_squares(const std::vector<Form>& equations,
                                        const std::vector<TensorProductSpace>& functions,
                                        const std::function<void()>& solve_system,
                                        ScalarSolution& solution) const {
  // Errors of the coefficients are about ε over the eigenvalue.
  constexpr double smallest = 1e-6;
  std::string normal_equations = "are singular to working precision";
  try {
    solve_system();
    // Conjugate gradients estimate nothing; they stop by their residual.
    const LinearSolution& linear = solution.linear;
    // The start is the solution: nothing was solved.
    if (solution.newton.size() == 1 && solution.newton[0].step == 0) return false;
    if (linear.method == LinearSolution::Method::conjugate_gradient ||
        linear.smallest_eigenvalue >= smallest) {
      solution.notes.push_back(
          fmt::format("least squares by normal equations, whose smallest eigenvalue is {:.1e}",
                      linear.smallest_eigenvalue));
      return false;
    }
    normal_equations =
        fmt::format("have a smallest eigenvalue of {:.1e}", linear.smallest_eigenvalue);
  } catch (const SingularSystem&) {
    // What Q R cannot solve either, it reports.
  } catch (const ComputationError& error) {
    normal_equations = fmt::format("failed ({})", error.what());
  }
  solve_at_points(equations, functions, solution);
  solution.notes.push_back(
      fmt::format("least squares by Q R, because the normal equations {}; the smallest singular "
                  "value is {:.1e}",
                  normal_equations, solution.linear.smallest_eigenvalue));
  return true;
}

void ScalarProblem::solve_forms(const std::vector<Form>& equations,
                                const std::vector<TensorProductSpace>& functions,
                                ScalarSolution& solution) const {
  Stopwatch solve;
  NewtonOptions options;
  options.load_steps = problem_.discretization.load_steps;
  const Grid& grid = solution.rule.grid();
  const std::vector<Structure> structures = this->structures(grid);
  options.finer_rule = [&] { return finer_rule(solution.grid); };
  const std::optional<SplineExtraction> extraction =
      this->extraction(functions, solution.rule, solution.grid);
  if (extraction) options.extraction = &*extraction;
  std::optional<Eigen::VectorXd> start;
  for (const ContinuationStop& stop : continuation_stops(problem_)) {
    start = solved_stop(stop, functions, solution.rule, solution.grid, linear_options(), options,
                        start);
  }
  NewtonSolution newton;
  try {
    newton = solve_newton(structures, functions, equations, solution.rule, linear_options(),
                          options, start);
  } catch (const UnbalancedLoads& loads) {
    throw ComputationError(
        FreeFunctions(structures, functions).text(loads, problem_.physics.unknowns));
  }
  solution.newton_order = newton.order();
  solution.newton = std::move(newton.iterations);
  solution.linear = std::move(newton.linear);
  solution.seconds.solve = solve.seconds();
}

}  // namespace rfm
