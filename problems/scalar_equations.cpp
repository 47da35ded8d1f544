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

bool has_slots_of(const Contribution& part, int component) {
  return std::ranges::any_of(part.energy.stiffness(), [&](const QuadraticEnergy::Entry& entry) {
    return part.energy.slots()[entry.row].component == component &&
           part.energy.slots()[entry.column].component == component;
  });
}

// An unknown without mass follows from the others where it has a stiffness of its own; one that has
// neither, as a pressure, makes a saddle point, whose pivots need not exist.
void require_mass_or_stiffness(const Problem& problem, const EquationTerms& terms) {
  const auto has = [&](const std::vector<Contribution>& parts, std::size_t c) {
    return std::ranges::any_of(
        parts, [&](const Contribution& part) { return has_slots_of(part, static_cast<int>(c)); });
  };
  for (std::size_t c = 0; c < problem.physics.unknowns.size(); ++c)
    if (!has(terms.mass, c) && !has(terms.stiffness, c))
      throw ProblemFileErrors(
          {Mistake{fmt::format("'{0}' has no mass and no stiffness of its own, that is no {0}^2 or "
                               "square of its derivatives in the energy: modes of such saddle "
                               "points are not supported",
                               problem.physics.unknowns[c]),
                   problem.physics.coefficients.at("mass").place}});
}

// How far a field is below 0 at most.
double depth(const Field& field, const DomainRule& rule) {
  return maximum(select(step(field), 0.0, field), rule);
}

// ∫ m u² is the square of a norm.
void require_mass(const Problem& problem, const Field& mass, const DomainRule& rule) {
  const double lowest = depth(mass, rule);
  if (!(lowest > 0)) return;
  Place place = problem.document.place;
  for (const char* name : {"mass", "heat_capacity", "density"})
    if (const auto found = problem.physics.coefficients.find(name);
        found != problem.physics.coefficients.end())
      place = found->second.place;
  throw ProblemFileErrors(
      {Mistake{fmt::format("modes need a mass that is not negative: it is down to {:.3g}", -lowest),
               place}});
}

// Of the user's own mass the diagonal, and the minors of two derivatives: all where there are two
// unknowns. Lanczos' method does not see a place where few functions live.
void require_own_mass(const Problem& problem, const Contribution& mass, const DomainRule& rule) {
  const Place& place = problem.physics.coefficients.at("mass").place;
  if (!mass.energy.load().empty())
    throw ProblemFileErrors({Mistake{
        "the mass of modes is made of squares and products of unknowns: a part of it is linear",
        place}});
  const auto entry = [&](int row, int column) {
    Field sum = 0.0;
    for (const QuadraticEnergy::Entry& own : mass.energy.stiffness())
      if (own.row == row && own.column == column)
        for (const Coefficient::Term& term : own.coefficient.terms()) sum = sum + term.field;
    return sum;
  };
  constexpr double rounding = 1e-12;
  const int count = static_cast<int>(mass.energy.slots().size());
  for (int a = 0; a < count; ++a) {
    require_mass(problem, entry(a, a), rule);
    for (int b = a + 1; b < count; ++b) {
      const Field product = entry(a, a) * entry(b, b), square = pow(entry(a, b), 2);
      if (square.is_constant(0)) continue;
      if (depth((1 + rounding) * product - square, rule) > 0)
        throw ProblemFileErrors(
            {Mistake{"modes need a mass that is not negative: the product of two different "
                     "derivatives is too large for their squares",
                     place}});
    }
  }
}

}  // namespace

Equations ScalarProblem::equations(const DomainRule& rule, const Grid& grid) const {
  const bool eigen = problem_.study.type == Study::Type::eigen;
  EquationTerms terms;
  if (!eigen && uses_forms(*this)) {
    for (const Form& form : problem_forms(*this, rule.grid()))
      if (form.is_linear())
        terms.stiffness.push_back(form.linear());
      else
        terms.forms.push_back(form);
  } else if (problem_.physics.custom) {
    const Problem& file = problem_;
    for (const Form& form : problem_forms(*this, rule.grid()))
      terms.stiffness.push_back(quadratic(form, file));
    if (eigen) {
      terms.mass = {quadratic(Form::energy(file.physics.coefficients.at("mass").entries[0]), file)};
      require_mass_or_stiffness(file, terms);
      require_own_mass(file, terms.mass[0], rule);
    }
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
  for (int c = 0; c < unknown_count(); ++c)
    if (std::ranges::none_of(equations.terms().mass,
                             [&](const Contribution& part) { return has_slots_of(part, c); }))
      solution.notes.push_back(fmt::format("'{}' has no mass: it follows from the other unknowns",
                                           problem_.physics.unknowns[c]));
  solution.unknowns = equations.size();
  solution.results.dimension = problem_.dimension;
  Stopwatch assembly;
  equations.stiffness();
  equations.mass();
  solution.seconds.assembly = assembly.seconds();

  Stopwatch solve;
  const EigenResult& eigen = solution.eigen.emplace(find_modes(equations, problem_.study, bounds_));
  for (int c = 0; c < unknown_count(); ++c)
    solution.results.unknowns.push_back({problem_.physics.unknowns[c], eigen.modes[0][c]});
  solution.results.modes = eigen.modes;
  if (!problem_.physics.custom)
    solution.results.flux = conductive_flux(coefficients_, eigen.modes[0][0], problem_.dimension);
  solution.energy = 0.5 * eigen.values[0];  // of a mode of unit mass
  solution.linear.relative_residual = std::ranges::max(eigen.residuals);
  for (const std::vector<Field>& mode : eigen.modes)
    solution.boundary_residual =
        std::max(solution.boundary_residual, boundary_residual(mode, solution.rule));
  solution.seconds.solve = solve.seconds();
}

}  // namespace rfm
