// Problems in functions of the whole domain.

#include <fmt/format.h>

#include <algorithm>
#include <memory>

#include "basis/tensor_polynomials.hpp"
#include "core/error.hpp"
#include "problems/continuation.hpp"
#include "problems/problem_forms.hpp"
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

// Forms of any kind, in spaces of functions of the whole domain.
class GlobalForms {
 public:
  GlobalForms(const ScalarProblem& problem, const GlobalSpaces& spaces, const DomainRule& rule)
      : forms_(problem_forms(problem, rule.grid())),
        spaces_(spaces),
        rule_(rule),
        solution_(problem.structures(rule.grid()), spaces, {}, rule) {
    for (const Structure& structure : solution_.structures())
      changes_.push_back(homogeneous_part(structure));
  }

  FreeFunctions candidates() const { return FreeFunctions(solution_.structures(), spaces_); }

  const std::vector<Form>& forms() const { return forms_; }
  std::vector<Field> fields(const Eigen::VectorXd& coefficients) const {
    return solution_.fields(coefficients);
  }
  // Of forms that are linear: the system of the solution itself.
  LinearSystem linear() const {
    std::vector<Contribution> parts;
    for (const Form& form : forms_)
      parts.push_back(form.at(std::vector<Field>(form.slots().size(), 0.0)));
    return assemble_dense(solution_.structures(), spaces_, parts, rule_);
  }
  // Minus the residual where the whole solution is zero; nothing if data do not make it another
  // one than the start, or where it has no value.
  Eigen::VectorXd loads() const {
    const bool has_data = std::ranges::any_of(
        solution_.structures(),
        [](const Structure& structure) { return !structure.inhomogeneous().is_constant(0); });
    if (!has_data) return {};
    try {
      std::vector<Contribution> parts;
      const std::vector<Field> zero(changes_.size(), 0.0);
      for (const Form& form : forms_) parts.push_back(form.linearized(zero));
      return assemble_dense(changes_, spaces_, parts, rule_).right_hand_side;
    } catch (const ComputationError&) {  // not defined there, as a logarithm
      return {};
    }
  }
  // Tangent, and minus the residual; what is held may be so at another state.
  LinearSystem linearized(const Eigen::VectorXd& coefficients,
                          const Eigen::VectorXd* held = nullptr) const {
    const std::vector<Field> fields = this->fields(coefficients);
    std::vector<Field> held_fields;
    if (held) held_fields = this->fields(*held);
    std::vector<Contribution> parts;
    for (const Form& form : forms_) parts.push_back(form.linearized(fields, held_fields));
    return assemble_dense(changes_, spaces_, parts, rule_);
  }

 private:
  std::vector<Form> forms_;
  const GlobalSpaces& spaces_;
  const DomainRule& rule_;
  Equations solution_;
  std::vector<Structure> changes_;
};

NewtonSolution solved(const GlobalForms& forms, const LinearSolverOptions& linear,
                      const NewtonOptions& options, const Eigen::VectorXd& start,
                      const std::function<LinearSystem(const Eigen::VectorXd&)>& finer) {
  NewtonEquations equations;
  equations.candidates = forms.candidates().coefficients();
  equations.finer = finer;
  equations.loads = forms.loads();
  equations.at = [&](const Eigen::VectorXd& state) { return forms.linearized(state); };
  if (std::ranges::any_of(forms.forms(), &Form::holds_anything))
    equations.beside = [&](const Eigen::VectorXd& state, const Eigen::VectorXd& held) {
      return forms.linearized(state, &held);
    };
  return solve_newton(equations, start, linear, options);
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
  const GlobalForms forms(*this, spaces, rule);
  solution.unknowns = function_count() * spaces[0]->size();
  solution.linearity = linearity(forms.forms(), rule);
  LinearSolverOptions linear = linear_options();
  linear.rank_revealing = true;
  const FreeFunctions candidates = forms.candidates();
  Eigen::MatrixXd free;  // of the candidates
  std::optional<DomainRule> finer;
  const auto finer_forms = [&] {
    if (!finer) finer = finer_rule(rule.grid());
    return GlobalForms(*this, spaces, *finer);
  };
  const auto finer_tangent = [&](const Eigen::VectorXd& state) {
    return finer_forms().linearized(state);
  };
  if (solution.linearity != Linearity::none) {
    const LinearSystem system = forms.linear();
    const Kernel kernel(system, candidates.coefficients(), [&] { return finer_forms().linear(); });
    solution.linear = rfm::solve(kernel.pinned(system), linear);
    const double missing = kernel.incompatibility(system, solution.linear.coefficients);
    if (!(missing < Kernel::largest_imbalance))
      throw ComputationError(
          candidates.text(UnbalancedLoads(kernel.weights(), missing), problem_.physics.unknowns));
    free = kernel.weights();
    if (solution.linearity == Linearity::by_value &&
        !is_linear_at(system, solution.linear.coefficients,
                      forms.linearized(solution.linear.coefficients).right_hand_side))
      solution.linearity = Linearity::none;
  }
  if (solution.linearity == Linearity::none) {
    NewtonOptions options;
    options.load_steps = problem_.discretization.load_steps;
    Eigen::VectorXd start = Eigen::VectorXd::Zero(solution.unknowns);
    for (const ContinuationStop& stop : continuation_stops(problem_)) {
      const ScalarProblem before(stop.problem);
      start =
          solved(GlobalForms(before, spaces, rule), linear, options, start, {}).linear.coefficients;
    }
    NewtonSolution newton;
    try {
      newton = solved(forms, linear, options, start, finer_tangent);
    } catch (const UnbalancedLoads& loads) {
      throw ComputationError(candidates.text(loads, problem_.physics.unknowns));
    }
    solution.newton_order = newton.order();
    solution.newton = std::move(newton.iterations);
    solution.linear = std::move(newton.linear);
    const Eigen::VectorXd& state = solution.linear.coefficients;
    if (candidates.coefficients().cols() > 0)
      free = Kernel(forms.linearized(state), candidates.coefficients(), [&] {
               return finer_tangent(state);
             }).weights();
  }
  note_dependence(problem_.discretization, solution);
  solution.mean_set_to_zero = free.cols() > 0;
  const std::vector<Field> fields =
      candidates.without(free, forms.fields(solution.linear.coefficients), rule);
  for (int c = 0; c < unknown_count(); ++c)
    solution.results.unknowns.push_back({problem_.physics.unknowns[c], fields[c]});
  solution.energy = energy_of_forms(*this, solution);
  if (!problem_.physics.custom)
    for (const Field& component : conductive_flux(coefficients_, fields[0], problem_.dimension))
      solution.results.flux.push_back(with_solution(component, {&fields[0], 1}));
  solution.boundary_residual = boundary_residual(solution);
  solution.seconds.solve = solve.seconds();
}

}  // namespace rfm
