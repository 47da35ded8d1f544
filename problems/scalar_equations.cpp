// Equations as a bundle of matrices, and eigenproblems.

#include <fmt/format.h>

#include <algorithm>

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

// ∫ m u² is the square of a norm.
void require_mass(const Problem& problem, const Field& mass, const DomainRule& rule) {
  const double lowest = maximum(select(step(mass), 0.0, mass), rule);
  if (!(lowest > 0)) return;
  Place place = problem.document.place;
  for (const char* name : {"heat_capacity", "density"})
    if (const auto found = problem.physics.coefficients.find(name);
        found != problem.physics.coefficients.end())
      place = found->second.place;
  throw ProblemFileErrors(
      {Mistake{fmt::format("modes need a mass that is not negative: it is down to {:.3g}", -lowest),
               place}});
}

}  // namespace

Equations ScalarProblem::equations(const DomainRule& rule, const Grid& grid) const {
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
  if (!has_global_functions()) {
    std::vector<TensorProductSpace> functions = spaces(rule);
    std::optional<SplineExtraction> extraction = this->extraction(functions, rule, grid);
    return Equations(std::move(structures), std::move(functions), std::move(terms), rule,
                     std::move(extraction));
  }
  return Equations(std::move(structures), global_spaces(rule.grid()), std::move(terms), rule);
}

void ScalarProblem::solve_eigen(ScalarSolution& solution) const {
  if (!problem_.physics.custom) require_mass(problem_, coefficients_.mass, solution.rule);
  const Equations equations = this->equations(solution.rule, solution.grid);
  const bool has_values = std::ranges::any_of(
      structures(solution.rule.grid()),
      [](const Structure& structure) { return !structure.inhomogeneous().is_constant(0); });
  if (has_values || !equations.steady().right_hand_side.isZero(0))
    solution.notes.push_back(
        "modes are those of the equations without data: sources, fluxes and values other than 0 "
        "do not enter");
  solution.unknowns = equations.size();
  solution.results.dimension = problem_.dimension;
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
