#include "problems/partial_coverage.hpp"

#include <fmt/format.h>

#include "core/r_functions.hpp"
#include "problems/boundary_coverage.hpp"
#include "solvers/integrate.hpp"

namespace rfm {
namespace {

// The target of a condition that claims `piece` by this field.
const BoundaryTarget& target_of(const Condition& condition, const std::string& piece,
                                const Field& where) {
  for (const BoundaryTarget& target : condition.targets)
    if (target.where && target.where->same_as(where) &&
        std::ranges::find(target.pieces, piece) != target.pieces.end())
      return target;
  return condition.targets.front();
}

class PartChecker {
 public:
  PartChecker(const Problem& problem, const DomainRule& rule)
      : problem_(problem), rule_(rule), negligible_(1e-9 * rule.boundary_measure()) {}

  void check(const PieceConditions& piece, int primitive) {
    Field unclaimed = 1.0;
    for (std::size_t i = 0; i < piece.claims.size(); ++i) {
      const PieceClaim& claim = piece.claims[i];
      if (!claim.where) return;  // the rest of the piece is covered
      const Condition& condition = problem_.conditions[claim.condition];
      const BoundaryTarget& target = target_of(condition, piece.piece, *claim.where);
      const Field here = step(*claim.where);
      if (measure(here, primitive) <= negligible_)
        mistakes_.add(
            fmt::format("the region '{}' is empty: its 'where' is negative on all of '{}'",
                        target.name, piece.piece),
            target.place);
      for (std::size_t j = 0; j < i; ++j) {
        const PieceClaim& earlier = piece.claims[j];
        const Condition& other = problem_.conditions[earlier.condition];
        if (other.priority != condition.priority) continue;
        if (measure(here * step(*earlier.where), primitive) > negligible_)
          mistakes_.add(
              fmt::format("'{}' overlaps '{}': give one of the conditions a larger 'priority'",
                          target.name, target_of(other, piece.piece, *earlier.where).name),
              target.place, {{"the other is here", other.place}});
      }
      unclaimed = unclaimed * (1.0 - here);
    }
    const double left = measure(unclaimed, primitive);
    if (left > negligible_)
      mistakes_.add(
          fmt::format("a part of '{}' (measure {:.6g}) has no condition", piece.piece, left),
          problem_.conditions_place);
  }
  void throw_if_any() const { mistakes_.throw_if_any(); }

 private:
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
  const std::string key = problem.physics.type == PhysicsType::heat ? "conductivity" : "diffusivity";
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
