// How the conditions of a scalar problem are met: what holds by structure, and by which.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/error.hpp"
#include "core/regular_form.hpp"
#include "core/tape.hpp"
#include "problems/corner_notes.hpp"
#include "problems/function_support.hpp"
#include "problems/inner_structure.hpp"
#include "problems/interpolation.hpp"
#include "problems/material_kinks.hpp"
#include "problems/regular_data.hpp"
#include "problems/remainder_option.hpp"
#include "problems/scalar_problem.hpp"
#include "problems/structure_check.hpp"
#include "problems/structure_language.hpp"
#include "problems/user_structure.hpp"
#include "solvers/assembly.hpp"
#include "solvers/integrate.hpp"

namespace rfm {
namespace {

[[noreturn]] void refuse(const std::string& message, const Place& place) {
  throw ProblemFileErrors({Mistake{message, place}});
}

// Whether values of a field are finite at all points of a rule.
bool is_defined(const Field& field, const DomainRule& rule) {
  try {
    maximum(field, rule);
    maximum(field, rule, {Contribution::Place::boundary});
    return true;
  } catch (const ComputationError&) {
    return false;
  }
}

// Whether most of many pieces with values are shorter (in space smaller) than a cell, as of a
// polygon that stands for a curve: an R-function of many that are nearly parallel levels off as far
// from them as they are long, so that u/ω is rough within a cell.
bool pieces_are_short(const std::vector<PieceCondition>& conditions, const DomainRule& rule) {
  constexpr int few = 6;
  double cell = 1;
  for (int axis = 1; axis < rule.dimension(); ++axis) cell *= rule.grid().spacing(axis);
  int values = 0, short_ones = 0;
  for (const PieceCondition& piece : conditions) {
    if (piece.kind != Condition::Kind::value) continue;
    if (piece.clamped) return false;  // by structure only
    ++values;
    short_ones += rule.boundary_measure(piece.primitive) < cell;
  }
  return values > few && 2 * short_ones > values;
}

// Whether a weight is zero inside the domain, where its R-function is: what it multiplies could not
// be other than the data there.
bool vanishes_inside(const Field& weight, const std::vector<Irregularity>& irregularities,
                     const DomainRule& probe) {
  if (std::ranges::none_of(irregularities, [](const Irregularity& found) {
        return found.kind == Irregularity::Kind::interior_zero;
      }))
    return false;
  const double most = maximum(weight, probe);
  const Tape tape({weight}, {0}, probe.dimension());
  return std::ranges::any_of(irregularities, [&](const Irregularity& found) {
    return found.kind == Irregularity::Kind::interior_zero &&
           !(std::fabs(tape.value(found.place)) > 1e-7 * most);
  });
}

bool contains(const std::vector<PieceCondition>& list, const PieceCondition& condition) {
  return std::ranges::any_of(list, [&](const PieceCondition& other) {
    return other.primitive == condition.primitive && other.condition == condition.condition;
  });
}

}  // namespace

void ScalarProblem::plan_values(const DomainRule& probe) {
  natural_ = natural_pieces(conditions_, problem_, coefficients_, region_, bounds_, probe);
  inner_ = structure_options(problem_);
  const std::vector<UserStructure> own = user_structures(problem_, cell_sides(probe.grid()));
  if (!own.empty()) {
    plan_own_structures(own, probe);
  } else {
    const std::optional<BooleanExpression> form = regular_form(region_, bounds_);
    const std::optional<RemainderOption> remainder = remainder_option(problem_);
    int functions = unknown_count();
    for (int component = 0; component < unknown_count(); ++component) {
      DirichletPlan& plan = plans_.emplace_back(automatic_plan(component, probe, form));
      for (const PieceCondition& piece : plan.weakly)
        if (piece.clamped)
          refuse(fmt::format("'{}' can be clamped by structure only: whole pieces whose corners "
                             "are all clamped or held",
                             piece.name),
                 problem_.conditions[piece.condition].place);
      if (remainder) plan.weight = {remainder->factor, "remainder"};
      structures_.push_back(
          with_inner_conditions(plan, component, inner_, probe, bounds_, functions));
    }
    if (remainder) {
      check_remainder(*remainder, problem_, plans_, structures_, coefficients_, probe, region_);
      if (auto note = remainder_note(*remainder, probe)) plans_[0].remarks.push_back(*note);
    }
    for (std::string& note : kink_notes(problem_)) plans_[0].remarks.push_back(std::move(note));
    add_singular_functions(probe, functions);
    add_windows(functions);
  }
  require_natural(probe);
  std::vector<PieceCondition> by_structure;
  for (const DirichletPlan& plan : plans_)
    by_structure.insert(by_structure.end(), plan.by_structure.begin(), plan.by_structure.end());
  for (std::string& note :
       corner_notes(conditions_, by_structure, natural_, !own.empty(), region_, bounds_))
    plans_[0].remarks.push_back(std::move(note));
  for (const SetValue& value : inner_.values) {
    if (!reaches(value.where, probe))
      refuse(fmt::format("'{}' lies outside of the domain", value.set), value.place);
    const auto deviation =
        deviation_from(value.where, value.component, value.value, structures_, probe);
    if (!is_met(deviation))
      refuse(fmt::format("the structure does not take the value on '{}': {}", value.set,
                         deviation_text(*deviation, problem_.dimension)),
             value.place);
  }
}

void ScalarProblem::plan_interpolation() {
  const Interpolation result = interpolation(problem_, conditions_, region_, bounds_);
  structures_.push_back(result.structure);
  DirichletPlan& plan = plans_.emplace_back();
  plan.given = structures_[0];
  plan.data = plan.given.inhomogeneous();
  plan.interpolated_sets = result.sets;
  for (const PieceCondition& piece : conditions_)
    if (piece.kind == Condition::Kind::value) plan.by_structure.push_back(piece);
}

void ScalarProblem::add_singular_functions(const DomainRule& probe, int& functions) {
  for (const Enrichment& enrichment : inner_.enrichments) {
    if (unknown_count() > 1)
      refuse("singular functions are those of one unknown", enrichment.place);
    if (!natural_.empty())
      refuse("singular functions do not go with fluxes by structure", enrichment.place);
    std::string names;
    for (const SingularTerm& term : singular_terms(enrichment, conditions_, region_, probe)) {
      structures_[0] = structures_[0] + term.factor * Structure::undetermined(functions++);
      names += (names.empty() ? "" : ", ") + term.text;
    }
    plans_[0].remarks.push_back(fmt::format("singular functions at ({:.6g}, {:.6g}): {}",
                                            enrichment.at[0], enrichment.at[1], names));
    for (const PieceCondition& condition : plans_[0].by_structure)
      if (const auto deviation =
              deviation_from(condition, structures_, coefficients_, probe, region_);
          !is_met(deviation))
        refuse(fmt::format("a singular function does not vanish on '{}': {}", condition.name,
                           deviation_text(*deviation, problem_.dimension)),
               enrichment.place);
  }
}

DirichletPlan ScalarProblem::automatic_plan(int component, const DomainRule& probe,
                                            const std::optional<BooleanExpression>& form) const {
  std::vector<PieceCondition> own;
  std::vector<bool> regular;
  for (const PieceCondition& condition : conditions_) {
    if (condition.component != component) continue;
    own.push_back(condition);
    regular.push_back(
        condition.kind != Condition::Kind::value || condition.data[0].is_constant() ||
        (is_regular(condition.data[0], region_, bounds_) && is_defined(condition.data[0], probe)));
  }
  const bool is_automatic =
      !has_global_functions() && std::holds_alternative<AutomaticRule>(problem_.combine.rule);
  const bool are_short = is_automatic && pieces_are_short(own, probe);
  const auto enforce_weakly = [&] {
    for (PieceCondition& condition : own)
      if (condition.enforcement == Condition::Enforcement::automatic)
        condition.enforcement = Condition::Enforcement::weak;
  };
  if (are_short) enforce_weakly();
  try {
    const auto plan_own = [&] {
      return plan_dirichlet(own, region_, bounds_, problem_.combine, regular, form);
    };
    DirichletPlan plan = plan_own();
    if (are_short)
      plan.remarks.emplace_back(
          "values are enforced weakly: most pieces are shorter than a cell, where a structure is "
          "rough");
    if (!is_automatic || plan.uses_regular_form || plan.by_structure.empty() ||
        std::ranges::any_of(plan.by_structure, &PieceCondition::clamped) ||
        !vanishes_inside(plan.weight.function, irregularities_, probe))
      return plan;
    enforce_weakly();
    plan = plan_own();
    plan.remarks.emplace_back(
        "values are enforced weakly: the function of the domain is zero inside it, and a structure "
        "would be, too");
    return plan;
  } catch (const InvalidArgument& error) {  // a cap that is not positive, corners inside
    const DocumentNode* geometry = problem_.document.find("geometry");
    const DocumentNode* combine = geometry ? geometry->find("combine") : nullptr;
    refuse(error.what(), combine ? combine->place : problem_.document.place);
  }
}

// Structures of the user's own take all values but those that are to be enforced weakly, or are by
// themselves.
void ScalarProblem::plan_own_structures(const std::vector<UserStructure>& own,
                                        const DomainRule& probe) {
  for (const UserStructure& user : own) {
    structures_.push_back(user.structure);
    own_use_cells_ = own_use_cells_ || Expression(user.text).uses("near");
  }
  for (int component = 0; component < unknown_count(); ++component) {
    const UserStructure& user = own[component];
    DirichletPlan plan;
    plan.data = user.structure.inhomogeneous();
    plan.own_structure = user.text;
    std::optional<DirichletPlan> automatic;
    for (const PieceCondition& condition : conditions_) {
      if (condition.kind != Condition::Kind::value || condition.component != component) continue;
      if (condition.enforcement == Condition::Enforcement::weak) {
        plan.weakly.push_back(condition);
        continue;
      }
      const auto deviation = deviation_from(condition, structures_, coefficients_, probe, region_);
      if (is_met(deviation)) {
        plan.by_structure.push_back(condition);
        continue;
      }
      if (!automatic) automatic = automatic_plan(component, probe, regular_form(region_, bounds_));
      if (condition.clamped || !contains(automatic->weakly, condition))
        refuse(fmt::format("this structure does not take the value on '{}': {}", condition.name,
                           deviation_text(*deviation, problem_.dimension)),
               user.place);
      plan.weakly.push_back(condition);
      plan.remarks.push_back(fmt::format(
          "value at {} is enforced weakly: the structure does not take it", condition.name));
    }
    plans_.push_back(std::move(plan));
  }
}

void ScalarProblem::require_natural(const DomainRule& probe) const {
  if (natural_.empty()) return;
  const std::vector<Structure> list = structures(probe.grid());
  for (const NaturalPiece& piece : natural_) {
    const auto deviation = deviation_from(piece.condition, list, coefficients_, probe, region_);
    if (is_met(deviation)) continue;
    const std::string off = deviation_text(*deviation, problem_.dimension);
    const std::string& own = plans_[0].own_structure;
    if (!own.empty())
      refuse(fmt::format("this structure does not satisfy the condition on '{}': {}",
                         piece.condition.name, off),
             user_structures(problem_, cell_sides(probe.grid()))[0].place);
    refuse(fmt::format("the condition at '{}' cannot be enforced by structure: {}",
                       piece.condition.name, off),
           problem_.conditions[piece.condition.condition].place);
  }
}

NaturalStructure ScalarProblem::natural_structure(const Grid& grid) const {
  std::optional<PrescribedValues> values;
  if (!plans_[0].weight.function.is_constant())
    values = {plans_[0].weight.function, plans_[0].nearest};
  return with_natural_conditions(structures_[0], values, natural_, coefficients_, bounds_,
                                 cell_sides(grid), structures_[0].unknown_count());
}

std::vector<Structure> ScalarProblem::structures(const Grid& grid) const {
  if (own_use_cells_) {
    std::vector<Structure> result;
    for (const UserStructure& user : user_structures(problem_, cell_sides(grid)))
      result.push_back(user.structure);
    return result;
  }
  if (natural_.empty() || !plans_[0].own_structure.empty()) return structures_;
  return {natural_structure(grid).structure};
}

std::vector<std::optional<std::string>> ScalarProblem::structure_lines(const Grid& grid) const {
  std::vector<std::optional<std::string>> lines;
  for (const DirichletPlan& plan : plans_)
    if (!plan.own_structure.empty()) lines.emplace_back(plan.own_structure);
  if (!lines.empty()) return lines;
  const CellSides cell = cell_sides(grid);
  if (!natural_.empty()) {
    const NaturalStructure natural = natural_structure(grid);
    return {structure_line(natural.structure, problem_, conditions_, cell, natural.calls)};
  }
  for (const Structure& structure : structures_)
    lines.push_back(structure_line(structure, problem_, conditions_, cell));
  return lines;
}

int ScalarProblem::function_count() const {
  int count = unknown_count();
  for (const Structure& structure : structures_) count = std::max(count, structure.unknown_count());
  const bool is_corrected = !natural_.empty() && plans_[0].own_structure.empty();
  return is_corrected ? count + 1 : count;
}

}  // namespace rfm
