#include "problems/boundary_coverage.hpp"

#include <algorithm>
#include <functional>
#include <map>
#include <numeric>
#include <set>
#include <string_view>

namespace rfm {
namespace {

/// What earlier conditions of one priority claim of one piece. Two claims certainly overlap if one
/// is of the whole piece or if they are of the same region; whether two regions do is geometric.
struct EarlierClaims {
  const BoundaryTarget* whole = nullptr;
  std::map<std::string_view, const BoundaryTarget*> parts;

  /// An earlier claim that overlaps `target`.
  const BoundaryTarget* find(const BoundaryTarget& target) const {
    if (whole || parts.empty()) return whole;
    if (!target.where) return parts.begin()->second;
    const auto same = parts.find(target.name);
    return same == parts.end() ? nullptr : same->second;
  }
  void add(const BoundaryTarget& target) {
    if (target.where)
      parts.emplace(target.name, &target);
    else if (!whole)
      whole = &target;
  }
};

bool is_rest(const Condition& condition) {
  return std::ranges::any_of(condition.targets, [](const BoundaryTarget& target) {
    return target.kind == BoundaryTarget::Kind::rest;
  });
}

/// Numbers of the conditions by falling priority, those of equal priority in the file's order.
std::vector<int> by_priority(const std::vector<Condition>& conditions) {
  std::vector<int> order(conditions.size());
  std::iota(order.begin(), order.end(), 0);
  std::ranges::stable_sort(order, std::greater<>(),
                           [&](int i) { return conditions[static_cast<std::size_t>(i)].priority; });
  return order;
}

}  // namespace

std::vector<PieceConditions> assign_conditions(const Problem& problem,
                                               const std::vector<std::string>& pieces) {
  std::vector<PieceConditions> assigned;
  std::map<std::string_view, std::size_t> number;
  for (const std::string& piece : pieces) {
    number.emplace(piece, assigned.size());
    assigned.push_back({piece, {}, false});
  }
  const auto claim = [](PieceConditions& piece, int condition, const std::optional<Field>& where,
                        bool chosen_by_geometry) {
    // Claims after one of the whole piece never rule.
    if (!piece.is_covered) piece.claims.push_back({condition, where, chosen_by_geometry});
    piece.is_covered = piece.is_covered || !where;
  };
  const std::vector<int> order = by_priority(problem.conditions);
  const auto claim_all = [&](int i, bool chosen_by_geometry) {
    for (const BoundaryTarget& target : problem.conditions[static_cast<std::size_t>(i)].targets)
      for (const std::string& piece : target.pieces)
        if (const auto found = number.find(piece);
            found != number.end() && target.chosen_by_geometry == chosen_by_geometry)
          claim(assigned[found->second], i, target.where_on(piece), chosen_by_geometry);
  };
  // Of equal priority, those that may turn out not to meet a piece come first.
  for (auto first = order.begin(); first != order.end();) {
    const auto last = std::find_if(first, order.end(), [&](int i) {
      return problem.conditions[static_cast<std::size_t>(i)].priority !=
             problem.conditions[static_cast<std::size_t>(*first)].priority;
    });
    for (const bool chosen_by_geometry : {true, false})
      for (auto i = first; i != last; ++i) claim_all(*i, chosen_by_geometry);
    first = last;
  }
  // What no other condition names, whatever the priorities.
  for (const int i : order)
    if (is_rest(problem.conditions[static_cast<std::size_t>(i)]))
      for (PieceConditions& piece : assigned) claim(piece, i, {}, false);
  return assigned;
}

void check_boundary_coverage(const Problem& problem, const std::vector<std::string>& pieces) {
  MistakeList mistakes;
  const std::set<std::string> known(pieces.begin(), pieces.end());
  for (const Condition& condition : problem.conditions)
    for (const BoundaryTarget& target : condition.targets)
      if (target.kind == BoundaryTarget::Kind::pieces &&
          std::ranges::none_of(target.pieces,
                               [&](const std::string& piece) { return known.contains(piece); }))
        mistakes.add("'" + target.name + "' is not part of the boundary of the domain",
                     target.place);
  if (problem.physics.type == PhysicsType::interpolation)
    return mistakes.throw_if_any();  // data may be anywhere
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
  std::map<std::pair<std::string, int>, EarlierClaims> earlier;  // by piece and priority
  for (const Condition& condition : problem.conditions) {
    const BoundaryTarget* other = nullptr;
    const BoundaryTarget* target = nullptr;
    std::string piece;
    for (const BoundaryTarget& candidate : condition.targets)
      for (const std::string& name : candidate.pieces)
        if (!other && !candidate.chosen_by_geometry &&
            (other = earlier[{name, condition.priority}].find(candidate))) {
          target = &candidate;
          piece = name;
        }
    if (other)
      mistakes.add("two conditions for '" + piece + "': give one of them a larger 'priority'",
                   target->place, {{"the other is here", other->place}});
    for (const BoundaryTarget& claim : condition.targets)
      for (const std::string& name : claim.pieces)
        if (!claim.chosen_by_geometry) earlier[{name, condition.priority}].add(claim);
  }
}

}  // namespace rfm
