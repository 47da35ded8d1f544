#include "problems/partial_coverage.hpp"

#include <fmt/format.h>

#include "core/r_functions.hpp"
#include "problems/boundary_coverage.hpp"
#include "solvers/integrate.hpp"

namespace rfm {
namespace {

// The target of a condition that claims `piece`, or the part of it that a field chooses.
const BoundaryTarget& target_of(const Condition& condition, const std::string& piece,
                                const std::optional<Field>& where) {
  for (const BoundaryTarget& target : condition.targets) {
    if (std::ranges::find(target.pieces, piece) == target.pieces.end()) continue;
    const std::optional<Field> part = target.where_on(piece);
    if (where ? part && part->same_as(*where) : !part) return target;
  }
  return condition.targets.front();
}

bool is_rest(const BoundaryTarget& target) { return target.kind == BoundaryTarget::Kind::rest; }

class PartChecker {
 public:
  PartChecker(const Problem& problem, const DomainRule& rule)
      : problem_(problem), rule_(rule), negligible_(1e-9 * rule.boundary_measure()) {}

  void check(const PieceConditions& piece, int primitive) {
    Field unclaimed = 1.0;
    for (std::size_t i = 0; i < piece.claims.size(); ++i) {
      const PieceClaim& claim = piece.claims[i];
      const Condition& condition = problem_.conditions[claim.condition];
      const BoundaryTarget& target = target_of(condition, piece.piece, claim.where);
      const Field here = claim.where ? step(*claim.where) : Field(1.0);
      if (!is_rest(target)) check_overlaps(piece, i, target, primitive);
      if (!claim.where) return;  // the rest of the piece is covered
      unclaimed = unclaimed * (1.0 - here);
    }
    const double left = measure(unclaimed, primitive);
    if (left > negligible_)
      mistakes_.add(
          fmt::format("a part of '{}' (measure {:.6g}) has no condition", piece.piece, left),
          problem_.conditions_place);
  }
  // The whole region, of which some pieces may hold nothing if it was chosen by geometry.
  void check_empty(const BoundaryTarget& target, const std::vector<std::string>& names,
                   const std::vector<int>& primitives) {
    if (!target.where && target.parts.empty()) return;
    double total = 0;
    for (std::size_t i = 0; i < names.size(); ++i) {
      if (std::ranges::find(target.pieces, names[i]) == target.pieces.end()) continue;
      const std::optional<Field> where = target.where_on(names[i]);
      const double part = measure(where ? step(*where) : Field(1.0), primitives[i]);
      if (target.where && part <= negligible_)
        mistakes_.add(
            fmt::format(
                fmt::runtime(part > 0 ? "the region '{}' is empty: its 'where' is 0 or more on "
                                        "less than a billionth of the boundary, a part of '{}'"
                                      : "the region '{}' is empty: this grid shows no part of "
                                        "'{}' where its 'where' is 0 or more"),
                target.name, names[i]),
            target.place);
      total += part;
    }
    if (!target.where && total <= negligible_)
      mistakes_.add(fmt::format("the region '{}' is empty: nothing of the boundary belongs to it",
                                target.name),
                    target.place);
  }
  void throw_if_any() const { mistakes_.throw_if_any(); }

 private:
  void check_overlaps(const PieceConditions& piece, std::size_t i, const BoundaryTarget& target,
                      int primitive) {
    const PieceClaim& claim = piece.claims[i];
    const Condition& condition = problem_.conditions[claim.condition];
    for (std::size_t j = 0; j < i; ++j) {
      const PieceClaim& earlier = piece.claims[j];
      const Condition& other = problem_.conditions[earlier.condition];
      if (&other == &condition || other.priority != condition.priority) continue;
      const Field both = step(*earlier.where) * (claim.where ? step(*claim.where) : Field(1.0));
      if (measure(both, primitive) > negligible_)
        mistakes_.add(
            fmt::format("'{}' overlaps '{}': give one of the conditions a larger 'priority'",
                        target.name, target_of(other, piece.piece, earlier.where).name),
            target.place, {{"the other is here", other.place}});
    }
  }
  double measure(const Field& indicator, int primitive) const {
    return integrate(indicator, rule_, {Contribution::Place::boundary, {primitive}});
  }

  const Problem& problem_;
  const DomainRule& rule_;
  double negligible_;
  MistakeList mistakes_;
};

}  // namespace

void check_parts(const Problem& problem, const RegionEvaluator& region,
                 const std::vector<int>& bounding_primitives, const DomainRule& rule) {
  std::vector<std::string> names;
  for (int primitive : bounding_primitives)
    names.push_back(region.region().primitives()[primitive]->name);
  PartChecker checker(problem, rule);
  for (const Condition& condition : problem.conditions)
    for (const BoundaryTarget& target : condition.targets)
      checker.check_empty(target, names, bounding_primitives);
  for (const Probe& probe : problem.probes)
    if (probe.boundary) checker.check_empty(*probe.boundary, names, bounding_primitives);
  const std::vector<PieceConditions> assigned = assign_conditions(problem, names);
  for (std::size_t i = 0; i < assigned.size(); ++i)
    checker.check(assigned[i], bounding_primitives[i]);
  checker.throw_if_any();
}

void check_materials(const Problem& problem, const DomainRule& rule) {
  const std::vector<Material>& materials = problem.physics.materials;
  const double negligible = 1e-9 * rule.measure();
  const auto indicator = [](const Material& material) {
    return step(implicit(*material.region, RAlpha{1}));
  };
  MistakeList mistakes;
  Field uncovered = 1.0;
  bool has_rest = materials.empty();
  for (std::size_t i = 0; i < materials.size(); ++i) {
    has_rest = has_rest || !materials[i].region;
    if (!materials[i].region) continue;
    const Field here = indicator(materials[i]);
    uncovered = uncovered * (1.0 - here);
    for (std::size_t j = 0; j < i; ++j)
      if (materials[j].region && integrate(here * indicator(materials[j]), rule) > negligible)
        mistakes.add(fmt::format("the materials in '{}' and '{}' overlap", materials[j].text,
                                 materials[i].text),
                     materials[i].place, {{"the other is here", materials[j].place}});
  }
  const PhysicsType type = problem.physics.type;
  if (type == PhysicsType::custom)
    return mistakes.throw_if_any();  // what is missing, assembly tells
  const std::string key = type == PhysicsType::heat       ? "conductivity"
                          : type == PhysicsType::membrane ? "tension"
                          : type == PhysicsType::torsion  ? "modulus"
                                                          : "diffusivity";
  if (!has_rest && !problem.physics.coefficients.contains(key)) {
    const double measure = integrate(uncovered, rule);
    if (measure > negligible)
      mistakes.add(fmt::format("no material covers a part of the domain (measure {:.6g}); expected "
                               "one with 'in: rest', or a '{}' beside 'materials'",
                               measure, key),
                   materials.front().place);
  }
  mistakes.throw_if_any();
}

}  // namespace rfm
