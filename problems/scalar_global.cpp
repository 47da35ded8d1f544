// Problems in functions of the whole domain.

#include <fmt/format.h>

#include <algorithm>
#include <memory>

#include "basis/tensor_polynomials.hpp"
#include "core/error.hpp"
#include "problems/continuation.hpp"
#include "problems/problem_forms.hpp"
#include "problems/residual_check.hpp"
#include "problems/scalar_problem.hpp"
#include "problems/stopwatch.hpp"
#include "solvers/free_functions.hpp"
#include "solvers/integrate.hpp"
#include "solvers/kernel.hpp"

namespace rfm {
namespace {

PolynomialFamily polynomial_family(const Discretization& discretization) {
  using Kind = PolynomialFamily::Kind;
  PolynomialFamily family{Kind::legendre, discretization.degree, discretization.total_degree};
  if (discretization.basis == Discretization::Basis::chebyshev) family.kind = Kind::chebyshev;
  if (discretization.basis == Discretization::Basis::power) family.kind = Kind::power;
  if (discretization.basis == Discretization::Basis::trigonometric)
    family.kind = Kind::trigonometric;
  return family;
}

void note_dependence(const Discretization& discretization, ScalarSolution& solution) {
  constexpr int highest_degree = 16;
  const bool trigonometric = discretization.basis == Discretization::Basis::trigonometric;
  if (!trigonometric && discretization.degree > highest_degree)
    solution.notes.push_back(fmt::format(
        "warning: polynomials above degree {} nearly depend on each other on a part of their box, "
        "and digits are lost",
        highest_degree));
  if (solution.linear.dependent > 0)
    solution.notes.push_back(fmt::format(
        "warning: {} of {} combinations of functions vanish to working precision and were left "
        "out; the smallest eigenvalue of the others is {:.1e}",
        solution.linear.dependent, solution.unknowns, solution.linear.smallest_eigenvalue));
}

// Of forms that are linear: the system of the solution itself.
LinearSystem linear_system(const Equations& equations) {
  std::vector<Contribution> parts;
  for (const Form& form : equations.terms().forms)
    parts.push_back(form.at(std::vector<Field>(form.slots().size(), 0.0)));
  return equations.assembled(parts);
}

}  // namespace

GlobalSpaces ScalarProblem::global_spaces(const Grid& grid) const {
  return GlobalSpaces(
      static_cast<std::size_t>(function_count()),
      std::make_shared<TensorPolynomials>(grid.box(), polynomial_family(problem_.discretization)));
}

// Built-in equations with an energy, of one unknown.
void ScalarProblem::solve_global_energy(ScalarSolution& solution) const {
  const Equations equations = this->equations(solution.rule, solution.grid);
  solution.unknowns = equations.size();
  const bool free_constant = fixed_up_to_constant();
  Stopwatch assembly;
  const LinearSystem& system = equations.steady();
  solution.seconds.assembly = assembly.seconds();

  Stopwatch solve;
  LinearSolverOptions options = linear_options();
  options.rank_revealing = true;
  const FreeFunctions candidates(equations.structures(), global_spaces(solution.rule.grid()));
  const Kernel kernel(
      system, free_constant ? candidates.coefficients() : Eigen::MatrixXd(system.size(), 0));
  solution.linear = rfm::solve(kernel.pinned(system), options);
  note_dependence(problem_.discretization, solution);
  Field u = equations.fields(solution.linear.coefficients)[0];
  solution.results.unknowns = {{problem_.physics.unknowns[0], u}};
  solution.energy = stored_energy(system, equations.terms().stiffness, solution);
  if (free_constant) {
    u = u - integrate(u, solution.rule) / solution.rule.measure();
    solution.results.unknowns[0].field = u;
    solution.mean_set_to_zero = true;
  }
  solution.results.flux = conductive_flux(coefficients_, u, problem_.dimension);
  solution.boundary_residual = boundary_residual(solution);
  solution.seconds.solve = solve.seconds();
}

// Equations given as formulas, and those that are not linear.
void ScalarProblem::solve_global_forms(ScalarSolution& solution) const {
  Stopwatch solve;
  const DomainRule& rule = solution.rule;
  const GlobalSpaces spaces = global_spaces(rule.grid());
  const auto bundle = [&](const ScalarProblem& problem) {
    return Equations(problem.structures(rule.grid()), spaces,
                     {.stiffness = {}, .forms = problem_forms(problem, rule.grid())}, rule);
  };
  const Equations equations = bundle(*this);
  solution.unknowns = function_count() * spaces[0]->size();
  solution.linearity = linearity(equations.terms().forms, rule);
  LinearSolverOptions linear = linear_options();
  linear.rank_revealing = true;
  const FreeFunctions candidates(equations.structures(), spaces);
  Eigen::MatrixXd free;  // of the candidates
  std::optional<DomainRule> finer;
  const auto finer_equations = [&] {
    if (!finer) finer = finer_rule(rule.grid());
    return equations.with_rule(*finer);
  };
  if (solution.linearity != Linearity::none) {
    const LinearSystem system = linear_system(equations);
    const Kernel kernel(system, candidates.coefficients(),
                        [&] { return linear_system(finer_equations()); });
    solution.linear = rfm::solve(kernel.pinned(system), linear);
    const double missing = kernel.incompatibility(system, solution.linear.coefficients);
    if (!(missing < Kernel::largest_imbalance))
      throw ComputationError(
          candidates.text(UnbalancedLoads(kernel.weights(), missing), problem_.physics.unknowns));
    free = kernel.weights();
    if (solution.linearity == Linearity::by_value &&
        !is_linear_at(system, solution.linear.coefficients,
                      equations.linearized(solution.linear.coefficients).right_hand_side))
      solution.linearity = Linearity::none;
  }
  if (solution.linearity == Linearity::none) {
    NewtonOptions options;
    options.load_steps = problem_.discretization.load_steps;
    Eigen::VectorXd start = Eigen::VectorXd::Zero(solution.unknowns);
    for (const ContinuationStop& stop : continuation_stops(problem_)) {
      const ScalarProblem before(stop.problem);
      const Equations there = bundle(before);
      start = solve_newton(newton_equations(there), start, linear, options).linear.coefficients;
    }
    NewtonSolution newton;
    try {
      newton =
          solve_newton(newton_equations(equations, {}, [&] { return finer_rule(rule.grid()); }),
                       start, linear, options);
    } catch (const UnbalancedLoads& loads) {
      throw ComputationError(candidates.text(loads, problem_.physics.unknowns));
    }
    solution.newton_order = newton.order();
    solution.newton = std::move(newton.iterations);
    solution.linear = std::move(newton.linear);
    const Eigen::VectorXd& state = solution.linear.coefficients;
    if (candidates.coefficients().cols() > 0)
      free = Kernel(equations.linearized(state), candidates.coefficients(), [&] {
               return finer_equations().linearized(state);
             }).weights();
  }
  note_dependence(problem_.discretization, solution);
  solution.mean_set_to_zero = free.cols() > 0;
  const std::vector<Field> fields =
      candidates.without(free, equations.fields(solution.linear.coefficients), rule);
  for (int c = 0; c < unknown_count(); ++c)
    solution.results.unknowns.push_back({problem_.physics.unknowns[c], fields[c]});
  solution.energy = energy_of_forms(*this, solution);
  if (!problem_.physics.custom)
    for (const Field& component : conductive_flux(coefficients_, fields[0], problem_.dimension))
      solution.results.flux.push_back(with_solution(component, {&fields[0], 1}));
  solution.boundary_residual = boundary_residual(solution);
  warn_of_residuals(*this, equations.fields(Eigen::VectorXd::Zero(equations.size())), solution);
  solution.seconds.solve = solve.seconds();
}

}  // namespace rfm
