// Equations that are not linear, or hold at points, and the stops on the way to them.

#include <cmath>

#include "core/error.hpp"
#include "problems/continuation.hpp"
#include "problems/problem_forms.hpp"
#include "problems/scalar_problem.hpp"
#include "problems/stopwatch.hpp"
#include "solvers/collocation.hpp"

namespace rfm {
namespace {

// The coefficients at a stop of a continuation, from those at the one before.
Eigen::VectorXd solved_stop(const ContinuationStop& stop,
                            const std::vector<TensorProductSpace>& functions,
                            const DomainRule& rule, const LinearSolverOptions& linear,
                            const NewtonOptions& options,
                            const std::optional<Eigen::VectorXd>& start) {
  const ScalarProblem problem(stop.problem);
  if (std::abs(problem.rule(rule.grid()).measure() - rule.measure()) > 1e-9 * rule.measure())
    throw ComputationError(stop.name + ": continuation needs the same domain at all values");
  try {
    return solve_newton(problem.structures(rule.grid()), functions,
                        problem_forms(problem, rule.grid()), rule, linear, options, start)
        .linear.coefficients;
  } catch (const ComputationError& error) {
    throw ComputationError("at " + stop.name + ": " + error.what());
  }
}

}  // namespace

void ScalarProblem::solve_forms(const std::vector<Form>& equations,
                                const std::vector<TensorProductSpace>& functions,
                                ScalarSolution& solution) const {
  Stopwatch solve;
  NewtonOptions options;
  options.load_steps = problem_.discretization.load_steps;
  const bool at_points = problem_.discretization.method == Discretization::Method::collocation;
  const Grid& grid = solution.rule.grid();
  const std::vector<Structure> structures = this->structures(grid);
  std::optional<Eigen::VectorXd> start;
  for (const ContinuationStop& stop : continuation_stops(problem_)) {
    if (at_points) throw ComputationError("collocation has no continuation");
    start = solved_stop(stop, functions, solution.rule, linear_options(), options, start);
  }
  NewtonSolution newton = at_points ? solve_collocation(structures, functions, equations,
                                                        collocation_rule(grid), options)
                                    : solve_newton(structures, functions, equations, solution.rule,
                                                   linear_options(), options, start);
  solution.newton_order = newton.order();
  solution.newton = std::move(newton.iterations);
  solution.linear = std::move(newton.linear);
  solution.seconds.solve = solve.seconds();
}

}  // namespace rfm
