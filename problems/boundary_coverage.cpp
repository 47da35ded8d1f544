#include "problems/boundary_coverage.hpp"

#include <algorithm>
#include <functional>
#include <numeric>

namespace rfm {
namespace {

bool contains(const std::vector<std::string>& names, const std::string& name) {
  return std::ranges::find(names, name) != names.end();
}

const BoundaryTarget* target_at(const Condition& condition, const std::string& piece) {
  for (const BoundaryTarget& target : condition.targets)
    if (contains(target.pieces, piece)) return &target;
  return nullptr;
}

bool is_rest(const Condition& condition) {
  return std::ranges::any_of(condition.targets, [](const BoundaryTarget& target) {
    return target.kind == BoundaryTarget::Kind::rest;
  });
}

/// Numbers of the conditions by falling priority, those of equal priority in the file's order.
std::vector<int> by_priority(const std::vector<Condition>& conditions) {
  std::vector<int> order(conditions.size());
  std::iota(order.begin(), order.end(), 0);
  std::ranges::stable_sort(order, std::greater<>(), [&](int i) {
    return conditions[static_cast<std::size_t>(i)].priority;
  });
  return order;
}

PieceConditions claims_of(const Problem& problem, const std::string& piece) {
  PieceConditions result{piece, {}, false};
  const auto claim = [&](int condition, const std::optional<Field>& where) {
    // Claims after one of the whole piece never rule.
    if (!result.is_covered) result.claims.push_back({condition, where});
    result.is_covered = result.is_covered || !where;
  };
  const std::vector<int> order = by_priority(problem.conditions);
  for (const int i : order)
    for (const BoundaryTarget& target : problem.conditions[static_cast<std::size_t>(i)].targets)
      if (contains(target.pieces, piece)) claim(i, target.where);
  // What no other condition names, whatever the priorities.
  for (const int i : order)
    if (is_rest(problem.conditions[static_cast<std::size_t>(i)])) claim(i, {});
  return result;
}

}  // namespace

std::vector<PieceConditions> assign_conditions(const Problem& problem,
                                               const std::vector<std::string>& pieces) {
  std::vector<PieceConditions> assigned;
  for (const std::string& piece : pieces) assigned.push_back(claims_of(problem, piece));
  return assigned;
}

void check_boundary_coverage(const Problem& problem, const std::vector<std::string>& pieces) {
  MistakeList mistakes;
  for (const Condition& condition : problem.conditions)
    for (const BoundaryTarget& target : condition.targets)
      if (target.kind == BoundaryTarget::Kind::pieces &&
          std::ranges::none_of(target.pieces,
                               [&](const std::string& piece) { return contains(pieces, piece); }))
        mistakes.add("'" + target.name + "' is not part of the boundary of the domain",
                     target.place);
  std::vector<std::string> uncovered;
  for (const PieceConditions& piece : assign_conditions(problem, pieces))
    if (piece.claims.empty()) uncovered.push_back(piece.piece);
  std::string names;
  for (const std::string& piece : uncovered) names += (names.empty() ? "'" : ", '") + piece + "'";
  if (uncovered.size() == 1)
    mistakes.add("the boundary part " + names + " has no condition", problem.conditions_place);
  if (uncovered.size() > 1)
    mistakes.add("the boundary parts " + names + " have no condition", problem.conditions_place);
  mistakes.throw_if_any();
}

void check_overlaps(const Problem& problem, MistakeList& mistakes) {
  const Condition* rest = nullptr;
  for (const Condition& condition : problem.conditions) {
    if (!is_rest(condition)) continue;
    if (rest)
      mistakes.add("'rest' is named by two conditions", condition.place,
                   {{"the other is here", rest->place}});
    rest = &condition;
  }
  for (std::size_t i = 1; i < problem.conditions.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) {
      const Condition& later = problem.conditions[i];
      const Condition& earlier = problem.conditions[j];
      if (later.priority != earlier.priority) continue;
      for (const auto& primitive : problem.domain->primitives()) {
        const BoundaryTarget* a = target_at(later, primitive->name);
        const BoundaryTarget* b = target_at(earlier, primitive->name);
        if (!a || !b || (a->where && b->where && a->name != b->name)) continue;
        mistakes.add("two conditions for '" + primitive->name +
                         "': give one of them a larger 'priority'",
                     a->place, {{"the other is here", b->place}});
        break;
      }
    }
}

}  // namespace rfm
