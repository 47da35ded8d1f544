// What a solution is asked before it is believed: whether there is one, whether it is the only one,
// and whether its values on the boundary are those prescribed.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "core/boundary_piece.hpp"
#include "core/error.hpp"
#include "core/tape.hpp"
#include "problems/scalar_forms.hpp"
#include "problems/scalar_problem.hpp"
#include "problems/solution_jumps.hpp"
#include "solvers/energy.hpp"
#include "solvers/integrate.hpp"
#include "solvers/solution.hpp"

namespace rfm {

namespace {

// Whether sources and fluxes are known beforehand and nothing else acts, whatever the conductivity.
bool has_fluxes_only(const ScalarCoefficients& coefficients,
                     const std::vector<PieceCondition>& conditions) {
  if (!coefficients.advection.empty() || !coefficients.reaction.is_constant(0) ||
      has_symbols(coefficients.source))
    return false;
  return std::ranges::all_of(conditions, [&](const PieceCondition& condition) {
    if (std::ranges::any_of(condition.data, has_symbols)) return false;
    if (condition.kind == Condition::Kind::flux) return true;
    if (condition.kind == Condition::Kind::value) return false;
    if (condition.kind == Condition::Kind::oblique) return false;  // its kernel is looked for
    // No transfer, or a = 0, where robin's flux is that of a known conductivity.
    return condition.data[0].is_constant(0) && !depend_on_solution(coefficients);
  });
}

// Whether the conductivity depends on u itself, and not on its derivatives alone.
bool conducts_by_level(const ScalarCoefficients& coefficients, int dimension) {
  ScalarCoefficients conduction;
  conduction.conductivity = coefficients.conductivity;
  if (!depend_on_solution(conduction)) return false;
  const Form form = volume_form(conduction, dimension, false);
  const Slot level;
  const auto is_level = [&](const SymbolSlot& slot) {
    return slot.role != SymbolRole::test && slot.slot == level;
  };
  if (std::ranges::none_of(form.slots(), is_level)) return false;
  return std::ranges::any_of(conduction.conductivity, jumps_with_symbols) ||
         std::ranges::any_of(form.slots(), [&](const SymbolSlot& slot) {
           return slot.role == SymbolRole::test &&
                  !form.tangent(slot.slot, level, dimension).is_constant(0);
         });
}

}  // namespace

bool ScalarProblem::fixed_up_to_constant() const {
  return !problem_.physics.custom && !depend_on_solution(coefficients_) && inner_.values.empty() &&
         has_fluxes_only(coefficients_, conditions_);
}

// Where a direction is along the boundary it says nothing of the flux, so that there is no weak
// form. Where it goes over from outwards to inwards the problem is not well posed by any method.
void ScalarProblem::check_directions(const DomainRule& rule) const {
  using Method = Discretization::Method;
  const Method method = problem_.discretization.method;
  for (const PieceCondition& condition : conditions_) {
    if (condition.kind != Condition::Kind::oblique) continue;
    const std::vector<Field> normal = outward_normal(condition.primitive, region_);
    Field along = 0.0, square = 0.0;
    for (int axis = 0; axis < problem_.dimension; ++axis) {
      along = along + condition.data[axis + 1] * normal[axis];
      square = square + pow(condition.data[axis + 1], 2);
    }
    constexpr double least = 1e-3;
    const auto occurs = [&](const Field& where) {
      return maximum(condition.where ? where * step(*condition.where) : where, rule,
                     {Contribution::Place::boundary, {condition.primitive}}) > 0;
    };
    const Field oblique = least * sqrt(square);
    if (occurs(step(along - oblique)) && occurs(step(-along - oblique)))
      throw ProblemFileErrors({Mistake{
          fmt::format("the direction at '{}' points outwards here and inwards there: where it is "
                      "along the boundary between, u is not determined",
                      condition.name),
          problem_.conditions[condition.condition].place}});
    if (method == Method::least_squares || method == Method::collocation ||
        condition.enforcement == Condition::Enforcement::structure)
      continue;
    if (occurs(step(least * least * square - along * along)))
      throw ProblemFileErrors({Mistake{
          fmt::format("the derivative at '{}' is one along the boundary: by least squares or "
                      "collocation only (discretization.method)",
                      condition.name),
          problem_.conditions[condition.condition].place}});
  }
}

void ScalarProblem::check_compatible(const DomainRule& rule) const {
  if (problem_.physics.custom || !inner_.values.empty() ||
      !has_fluxes_only(coefficients_, conditions_))
    return;
  if (conducts_by_level(coefficients_, problem_.dimension))
    throw ProblemFileErrors(
        {Mistake{"only fluxes are given, so that nothing fixes the level of u, and with a "
                 "conductivity that contains u another level is another solution: give a value or "
                 "a convection somewhere, or a reaction",
                 problem_.conditions_place}});
  // ∫ f + ∫ q must vanish: the sum of all loads against the constant 1.
  double resultant = integrate(coefficients_.source, rule);
  double size = integrate(abs(coefficients_.source), rule);
  for (const PieceCondition& condition : conditions_)
    for (const Contribution& natural : natural_energy(condition, coefficients_))
      for (const auto& load : natural.energy.load()) {
        const IntegrationPlace place{Contribution::Place::boundary, natural.numbers};
        const Coefficient part =
            natural.where ? load.coefficient * Coefficient(step(*natural.where)) : load.coefficient;
        resultant += integrate(part, rule, place);
        // ∫ |q| or more: of one piece parts balance, too.
        const double area =
            integrate(natural.where ? step(*natural.where) : Field(1.0), rule, place);
        size += std::sqrt(area * integrate(part * part, rule, place));
      }
  // Quadrature keeps the balance to its own error, which is that of the solution.
  if (std::fabs(resultant) > 1e-6 * size)
    throw ComputationError(fmt::format(
        "no steady solution exists: nothing fixes the level of u, and sources and fluxes do not "
        "balance (their resultant is {:.6g})",
        resultant));
}

// The regularised system is answered also where it is singular. What it then gives to a right-hand
// side of the size of the regularisation, chosen at random, is undetermined: nothing where two
// functions merely describe the same u, but a function of the size of u where a condition is
// missing.
double ScalarProblem::undetermined_part(const LinearSystem& system,
                                        const std::vector<TensorProductSpace>& functions,
                                        const ScalarSolution& solution,
                                        const LinearSolverOptions& options,
                                        const SplineExtraction* extraction) const {
  const Eigen::VectorXd scale = system.matrix.diagonal().cwiseAbs().cwiseSqrt();
  const Eigen::VectorXd scaled = scale.cwiseProduct(solution.linear.coefficients);
  std::mt19937 engine(1);
  LinearSystem disturbed = system;
  for (Eigen::Index i = 0; i < scale.size(); ++i)
    disturbed.right_hand_side[i] = scale[i] * (static_cast<double>(engine()) / 0x80000000u - 1);
  disturbed.right_hand_side *=
      options.regularization * std::sqrt(scaled.squaredNorm() / static_cast<double>(scale.size()));
  const LinearSolution answer = rfm::solve(disturbed, options);
  const std::vector<Structure> structures = this->structures(solution.rule.grid());
  std::vector<Structure> homogeneous;
  for (const Structure& structure : structures) homogeneous.push_back(homogeneous_part(structure));
  const auto all = [&](const Eigen::VectorXd& coefficients) {
    return extraction ? Eigen::VectorXd(extraction->matrix * coefficients) : coefficients;
  };
  const std::vector<Field> open = solution_fields(homogeneous, functions, all(answer.coefficients)),
                           u = solution_fields(structures, functions,
                                               all(solution.linear.coefficients));
  double part = 0, whole = 0;
  for (std::size_t c = 0; c < u.size(); ++c) {
    part = std::hypot(part, norms(open[c], solution.rule).l2);
    whole = std::hypot(whole, norms(u[c], solution.rule).l2);
  }
  return whole > 0 ? part / whole : part;
}

double ScalarProblem::boundary_residual(const ScalarSolution& solution) const {
  std::vector<Field> fields;
  for (const ScalarResults::Unknown& unknown : solution.results.unknowns)
    fields.push_back(unknown.field);
  return boundary_residual(fields, solution.rule);
}

double ScalarProblem::boundary_residual(const std::vector<Field>& fields,
                                        const DomainRule& rule) const {
  // Pieces that one formula holds on are looked at together: a polygon has hundreds.
  struct Group {
    const PieceCondition* first;
    std::vector<int> primitives;
  };
  std::vector<Group> groups;
  for (const PieceCondition& condition : conditions_) {
    if (condition.kind != Condition::Kind::value) continue;
    const auto known = std::ranges::find_if(groups, [&](const Group& group) {
      return !condition.where && !group.first->where &&
             group.first->component == condition.component &&
             same_expression(group.first->data[0], condition.data[0]);
    });
    if (known != groups.end())
      known->primitives.push_back(condition.primitive);
    else
      groups.push_back({&condition, {condition.primitive}});
  }
  const bool eigen = problem_.study.type == Study::Type::eigen;
  double largest = 0;
  for (const auto& [first, primitives] : groups) {
    Field residual = fields[first->component];
    if (!eigen) residual = residual - first->data[0];
    if (first->where) residual = select(step(*first->where), residual, 0.0);
    largest =
        std::max(largest, maximum(residual, rule, {Contribution::Place::boundary, primitives}));
  }
  return largest;
}

}  // namespace rfm
