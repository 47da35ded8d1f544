// Eigenproblems, and functions of the whole domain: the equations as a bundle of matrices.

#include <fmt/format.h>

#include <algorithm>
#include <memory>

#include "basis/tensor_polynomials.hpp"
#include "problems/pinned_constant.hpp"
#include "problems/problem_forms.hpp"
#include "problems/scalar_problem.hpp"
#include "problems/stopwatch.hpp"
#include "solvers/integrate.hpp"

namespace rfm {
namespace {

// A form of an eigenproblem.
Contribution quadratic(const Form& form, const Problem& problem) {
  if (!form.is_linear())
    throw ProblemFileErrors({Mistake{"modes need an energy and a mass that are quadratic",
                                     problem.physics.custom->place}});
  return form.linear();
}

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

}  // namespace

Equations ScalarProblem::equations(const DomainRule& rule) const {
  const bool eigen = problem_.study.type == Study::Type::eigen;
  EquationTerms terms;
  if (problem_.physics.custom) {
    const Problem& file = problem_;
    for (const Form& form : problem_forms(*this, rule.grid()))
      terms.stiffness.push_back(quadratic(form, file));
    if (eigen)
      terms.mass = {quadratic(Form::energy(file.physics.coefficients.at("mass").entries[0]), file)};
  } else {
    terms.stiffness = contributions(rule.grid());
    if (eigen) terms.mass = {mass_energy(coefficients_)};
  }
  std::vector<Structure> structures;
  for (const Structure& structure : this->structures(rule.grid()))
    structures.push_back(eigen ? homogeneous_part(structure) : structure);
  if (!has_global_functions())
    return Equations(std::move(structures), spaces(rule), std::move(terms), rule);
  const auto functions = std::make_shared<TensorPolynomials>(
      rule.grid().box(), polynomial_family(problem_.discretization));
  return Equations(std::move(structures), GlobalSpaces{functions}, std::move(terms), rule);
}

// Problems with an energy, of one unknown.
void ScalarProblem::solve_equations(ScalarSolution& solution) const {
  const Equations equations = this->equations(solution.rule);
  solution.unknowns = equations.size();
  solution.results.dimension = problem_.dimension;
  if (problem_.study.type == Study::Type::eigen) return solve_eigen(equations, solution);
  const bool free_constant = fixed_up_to_constant();
  if (free_constant) check_compatible(solution.rule);
  Stopwatch assembly;
  LinearSystem system = equations.steady();
  if (free_constant) pin_one(system);
  solution.seconds.assembly = assembly.seconds();

  Stopwatch solve;
  LinearSolverOptions options = linear_options();
  options.rank_revealing = true;
  solution.linear = rfm::solve(system, options);
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

void ScalarProblem::solve_eigen(const Equations& equations, ScalarSolution& solution) const {
  Stopwatch assembly;
  equations.stiffness();
  equations.mass();
  solution.seconds.assembly = assembly.seconds();

  Stopwatch solve;
  const EigenResult& eigen = solution.eigen.emplace(find_modes(equations, problem_.study, bounds_));
  solution.results.unknowns = {{problem_.physics.unknowns[0], eigen.modes[0]}};
  solution.results.modes = eigen.modes;
  if (!problem_.physics.custom)
    solution.results.flux = conductive_flux(coefficients_, eigen.modes[0], problem_.dimension);
  solution.energy = 0.5 * eigen.values[0];  // of a mode of unit mass
  solution.linear.relative_residual = std::ranges::max(eigen.residuals);
  for (const Field& mode : eigen.modes)
    solution.boundary_residual =
        std::max(solution.boundary_residual, boundary_residual({mode}, solution.rule));
  solution.seconds.solve = solve.seconds();
}

}  // namespace rfm
