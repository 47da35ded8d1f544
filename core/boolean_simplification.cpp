#include "core/boolean_simplification.hpp"

#include <algorithm>
#include <map>

namespace rfm {
namespace {

using Kind = BooleanExpression::Kind;
using Node = BooleanExpression::Node;

Kind opposite(Kind kind) {
  return kind == Kind::conjunction   ? Kind::disjunction
         : kind == Kind::disjunction ? Kind::conjunction
                                     : kind;
}

bool joins(Kind kind) { return kind == Kind::conjunction || kind == Kind::disjunction; }

/// Finds the operands of chains that may be left out. Every sub-expression gets a number, equal
/// ones the same; a chain is known by the set of numbers of its operands.
class Redundancy {
 public:
  explicit Redundancy(const std::vector<Node>& nodes)
      : nodes_(nodes), number_(nodes.size()), dropped_(nodes.size(), false) {
    std::vector<Kind> user(nodes.size(), Kind::constant);
    for (const Node& node : nodes)
      if (joins(node.kind)) user[node.first] = user[node.second] = node.kind;
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      if (!joins(nodes[i].kind))
        number_[i] = leaf(static_cast<int>(i));
      else if (user[i] != nodes[i].kind)
        number_[i] = chain(static_cast<int>(i));
    }
  }

  bool is_dropped(int node) const { return dropped_[node]; }

 private:
  using Operands = std::vector<int>;  // sorted numbers

  int numbered(Kind kind, const Operands& operands) {
    const auto [known, is_new] = known_.emplace(std::pair(kind, operands), sets_.size());
    if (is_new) sets_.push_back({kind, operands});
    return static_cast<int>(known->second);
  }

  // Negations stand on variables only: the variable below has been numbered before.
  int leaf(int node) {
    const Node& leaf = nodes_[node];
    return numbered(leaf.kind, {leaf.kind == Kind::negation ? number_[leaf.first] : leaf.first});
  }

  // The number of the chain of operations of one kind that ends at `top`.
  int chain(int top) {
    const Kind kind = nodes_[top].kind;
    std::vector<int> operands, pending{top};
    while (!pending.empty()) {
      const Node& node = nodes_[pending.back()];
      const int at = pending.back();
      pending.pop_back();
      if (node.kind != kind) {
        operands.push_back(at);
        continue;
      }
      pending.push_back(node.second);
      pending.push_back(node.first);
    }
    Operands kept;
    for (const int operand : operands) kept.push_back(number_[operand]);
    std::ranges::sort(kept);
    kept.erase(std::unique(kept.begin(), kept.end()), kept.end());
    const Operands all = kept;
    std::erase_if(kept, [&](int number) { return is_absorbed(number, all, opposite(kind)); });
    std::vector<bool> taken(kept.size(), false);
    for (const int operand : operands) {
      const auto place = std::ranges::lower_bound(kept, number_[operand]);
      const bool is_kept = place != kept.end() && *place == number_[operand];
      dropped_[operand] = !is_kept || taken[place - kept.begin()];
      if (is_kept) taken[place - kept.begin()] = true;
    }
    return kept.size() == 1 ? kept[0] : numbered(kind, kept);
  }

  // Whether an operand, as a set joined the other way, holds another of the operands.
  bool is_absorbed(int number, const Operands& operands, Kind inner) const {
    const auto& set = sets_[number];
    if (set.kind != inner) return false;
    return std::ranges::any_of(operands, [&](int other) {
      if (other == number) return false;
      if (std::ranges::binary_search(set.operands, other)) return true;
      return sets_[other].kind == inner &&
             std::ranges::includes(set.operands, sets_[other].operands);
    });
  }

  struct Set {
    Kind kind;
    Operands operands;
  };
  const std::vector<Node>& nodes_;
  std::vector<int> number_;
  std::vector<bool> dropped_;
  std::map<std::pair<Kind, Operands>, std::size_t> known_;
  std::vector<Set> sets_;
};

}  // namespace

namespace {

BooleanExpression shortened_once(const BooleanExpression& normal) {
  const std::vector<Node>& nodes = normal.nodes();
  const Redundancy redundancy(nodes);
  // Where each node's expression ends up in the new list; −1 where nothing of it is left.
  std::vector<int> place(nodes.size(), -1);
  std::vector<Node> kept;
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    if (redundancy.is_dropped(static_cast<int>(i))) continue;
    Node node = nodes[i];
    if (node.kind == Kind::negation) node.first = place[node.first];
    if (joins(node.kind)) {
      const int first = place[node.first], second = place[node.second];
      if (first < 0 || second < 0) {
        place[i] = std::max(first, second);
        continue;
      }
      node.first = first;
      node.second = second;
    }
    place[i] = static_cast<int>(kept.size());
    kept.push_back(node);
  }
  return BooleanExpression::of_nodes(kept, place.back());
}

}  // namespace

BooleanExpression without_redundancy(const BooleanExpression& expression) {
  // What is left of a chain may join the chain around it: until nothing changes.
  BooleanExpression result = expression.negations_at_leaves();
  for (;;) {
    BooleanExpression shorter = shortened_once(result);
    if (shorter.nodes().size() == result.nodes().size()) return result;
    result = std::move(shorter);
  }
}

BooleanExpression with_known_signs(const BooleanExpression& expression,
                                   std::span<const Truth> signs) {
  const std::vector<Node>& nodes = expression.nodes();
  const auto truth_of = [](bool value) { return value ? Truth::yes : Truth::no; };
  std::vector<Truth> values(nodes.size());
  std::vector<int> place(nodes.size(), -1);  // of nodes whose value is unknown
  std::vector<Node> open;
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    Node node = nodes[i];
    if (node.kind == Kind::constant) values[i] = truth_of(node.first != 0);
    if (node.kind == Kind::variable) values[i] = signs[node.first];
    if (node.kind == Kind::negation) {
      values[i] = static_cast<Truth>(-static_cast<int>(values[node.first]));
      node.first = place[node.first];
    }
    if (joins(node.kind)) {
      const Truth first = values[node.first], second = values[node.second];
      values[i] =
          node.kind == Kind::conjunction ? std::min(first, second) : std::max(first, second);
      if (values[i] == Truth::unknown && first != second) {  // only one of them is
        place[i] = place[first == Truth::unknown ? node.first : node.second];
        continue;
      }
      node.first = place[node.first];
      node.second = place[node.second];
    }
    if (values[i] != Truth::unknown) continue;
    place[i] = static_cast<int>(open.size());
    open.push_back(node);
  }
  if (values.back() != Truth::unknown)
    return BooleanExpression::constant(values.back() == Truth::yes);
  return BooleanExpression::of_nodes(open, place.back());
}

BooleanExpression dual(const BooleanExpression& expression) {
  std::vector<Node> nodes = expression.nodes();
  for (Node& node : nodes) {
    if (node.kind == Kind::constant) node.first = node.first == 0;
    node.kind = opposite(node.kind);
  }
  return BooleanExpression::of_nodes(nodes, static_cast<int>(nodes.size()) - 1);
}

BooleanExpression formal_complement(const BooleanExpression& expression) {
  return (!expression).negations_at_leaves();
}

}  // namespace rfm
