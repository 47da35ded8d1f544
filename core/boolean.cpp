#include "core/boolean.hpp"

#include <algorithm>
#include <array>
#include <memory>

namespace rfm {
namespace {

Truth opposite(Truth truth) { return static_cast<Truth>(-static_cast<int>(truth)); }

// Values of nodes live on the stack for expressions of usual size.
template <class T>
class Scratch {
 public:
  explicit Scratch(std::size_t size) {
    if (size > fixed_.size()) large_ = std::make_unique<T[]>(size);
  }
  T* data() { return large_ ? large_.get() : fixed_.data(); }

 private:
  std::array<T, 128> fixed_{};
  std::unique_ptr<T[]> large_;
};

}  // namespace

BooleanExpression BooleanExpression::constant(bool value) {
  BooleanExpression expression;
  expression.nodes_.push_back({Kind::constant, value ? 1 : 0, 0});
  return expression;
}

BooleanExpression BooleanExpression::variable(int number) {
  BooleanExpression expression;
  expression.nodes_.push_back({Kind::variable, number, 0});
  return expression;
}

BooleanExpression BooleanExpression::of_nodes(const std::vector<Node>& nodes, int root) {
  std::vector<bool> used(root + 1, false);
  used[root] = true;
  const auto binary = [](const Node& node) {
    return node.kind == Kind::conjunction || node.kind == Kind::disjunction;
  };
  for (int i = root; i >= 0; --i) {
    if (!used[i]) continue;
    if (nodes[i].kind == Kind::negation || binary(nodes[i])) used[nodes[i].first] = true;
    if (binary(nodes[i])) used[nodes[i].second] = true;
  }
  BooleanExpression expression;
  std::vector<int> place(root + 1, 0);
  for (int i = 0; i <= root; ++i) {
    if (!used[i]) continue;
    Node node = nodes[i];
    if (node.kind == Kind::negation || binary(node)) node.first = place[node.first];
    if (binary(node)) node.second = place[node.second];
    place[i] = static_cast<int>(expression.nodes_.size());
    expression.nodes_.push_back(node);
  }
  return expression;
}

int BooleanExpression::variable_count() const {
  int count = 0;
  for (const Node& node : nodes_)
    if (node.kind == Kind::variable) count = std::max(count, node.first + 1);
  return count;
}

namespace {

void evaluate_nodes(const std::vector<BooleanExpression::Node>& nodes, std::span<const Truth> signs,
                    Truth* values) {
  using Kind = BooleanExpression::Kind;
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    const auto& node = nodes[i];
    switch (node.kind) {
      case Kind::constant:
        values[i] = node.first ? Truth::yes : Truth::no;
        break;
      case Kind::variable:
        values[i] = signs[node.first];
        break;
      case Kind::negation:
        values[i] = opposite(values[node.first]);
        break;
      case Kind::conjunction:
        values[i] = std::min(values[node.first], values[node.second]);
        break;
      case Kind::disjunction:
        values[i] = std::max(values[node.first], values[node.second]);
        break;
    }
  }
}

}  // namespace

Truth BooleanExpression::evaluate(std::span<const Truth> signs) const {
  Scratch<Truth> values(nodes_.size());
  evaluate_nodes(nodes_, signs, values.data());
  return values.data()[nodes_.size() - 1];
}

bool BooleanExpression::evaluate(std::span<const bool> signs) const {
  Scratch<bool> scratch(nodes_.size());
  bool* const values = scratch.data();
  for (std::size_t i = 0; i < nodes_.size(); ++i) {
    const Node& node = nodes_[i];
    switch (node.kind) {
      case Kind::constant:
        values[i] = node.first != 0;
        break;
      case Kind::variable:
        values[i] = signs[node.first];
        break;
      case Kind::negation:
        values[i] = !values[node.first];
        break;
      case Kind::conjunction:
        values[i] = values[node.first] && values[node.second];
        break;
      case Kind::disjunction:
        values[i] = values[node.first] || values[node.second];
        break;
    }
  }
  return values[nodes_.size() - 1];
}

void BooleanExpression::mark_relevant(std::span<const Truth> signs,
                                      std::span<bool> relevant) const {
  Scratch<Truth> scratch(nodes_.size());
  Truth* const values = scratch.data();
  evaluate_nodes(nodes_, signs, values);
  Scratch<bool> reached_scratch(nodes_.size());
  bool* const reached = reached_scratch.data();
  std::fill(reached, reached + nodes_.size(), false);
  reached[nodes_.size() - 1] = true;
  // Users come after their arguments: one sweep backwards visits every user first.
  for (int i = static_cast<int>(nodes_.size()) - 1; i >= 0; --i) {
    if (!reached[i] || values[i] != Truth::unknown) continue;
    const Node& node = nodes_[i];
    if (node.kind == Kind::variable) relevant[node.first] = true;
    if (node.kind == Kind::negation) reached[node.first] = true;
    if (node.kind == Kind::conjunction || node.kind == Kind::disjunction)
      reached[node.first] = reached[node.second] = true;
  }
}

namespace {

/// A list of nodes under construction in which constants are absorbed at once.
class NodeList {
 public:
  using Kind = BooleanExpression::Kind;

  int add(const BooleanExpression::Node& node) {
    nodes_.push_back(node);
    return static_cast<int>(nodes_.size()) - 1;
  }
  int negation_of(int argument) {
    if (nodes_[argument].kind == Kind::constant)
      return add({Kind::constant, nodes_[argument].first == 0 ? 1 : 0, 0});
    if (nodes_[argument].kind == Kind::negation) return nodes_[argument].first;
    return add({Kind::negation, argument, 0});
  }
  int join_of(Kind kind, int first, int second) {
    const bool neutral = kind == Kind::conjunction;
    for (const auto& [one, other] : {std::pair(first, second), std::pair(second, first)})
      if (nodes_[one].kind == Kind::constant)
        return (nodes_[one].first != 0) == neutral ? other : one;
    return add({kind, first, second});
  }
  BooleanExpression expression(int root) const { return BooleanExpression::of_nodes(nodes_, root); }

 private:
  std::vector<BooleanExpression::Node> nodes_;
};

}  // namespace

BooleanExpression BooleanExpression::restricted(int number, bool value) const {
  NodeList list;
  std::vector<int> place;
  for (const Node& node : nodes_) {
    switch (node.kind) {
      case Kind::constant:
        place.push_back(list.add(node));
        break;
      case Kind::variable:
        place.push_back(
            list.add(node.first == number ? Node{Kind::constant, value ? 1 : 0, 0} : node));
        break;
      case Kind::negation:
        place.push_back(list.negation_of(place[node.first]));
        break;
      default:
        place.push_back(list.join_of(node.kind, place[node.first], place[node.second]));
    }
  }
  return list.expression(place.back());
}

BooleanExpression BooleanExpression::renamed(std::span<const int> new_number) const {
  BooleanExpression expression = *this;
  for (Node& node : expression.nodes_)
    if (node.kind == Kind::variable) node.first = new_number[node.first];
  return expression;
}

BooleanExpression BooleanExpression::negations_at_leaves() const {
  // Which of node and negated node are used, from the root down; then both are built.
  const int count = static_cast<int>(nodes_.size());
  std::vector<std::array<bool, 2>> used(count, {false, false});
  used.back()[0] = true;
  for (int i = count - 1; i >= 0; --i)
    for (const bool negated : {false, true}) {
      const Node& node = nodes_[i];
      if (!used[i][negated] || node.kind == Kind::constant || node.kind == Kind::variable) continue;
      used[node.first][node.kind == Kind::negation ? !negated : negated] = true;
      if (node.kind != Kind::negation) used[node.second][negated] = true;
    }
  NodeList list;
  std::vector<std::array<int, 2>> place(count);
  for (int i = 0; i < count; ++i)
    for (const bool negated : {false, true}) {
      if (!used[i][negated]) continue;
      const Node& node = nodes_[i];
      const bool conjunction = (node.kind == Kind::conjunction) != negated;
      if (node.kind == Kind::constant || node.kind == Kind::variable)
        place[i][negated] = negated ? list.negation_of(list.add(node)) : list.add(node);
      else if (node.kind == Kind::negation)
        place[i][negated] = place[node.first][!negated];
      else
        place[i][negated] = list.join_of(conjunction ? Kind::conjunction : Kind::disjunction,
                                         place[node.first][negated], place[node.second][negated]);
    }
  return list.expression(place.back()[0]);
}

BooleanExpression BooleanExpression::monotone_form(int variables) const {
  BooleanExpression expression = negations_at_leaves();
  for (Node& node : expression.nodes_)
    if (node.kind == Kind::negation)
      node = {Kind::variable, expression.nodes_[node.first].first + variables, 0};
  return expression;
}

bool BooleanExpression::is_constant(bool value) const {
  return nodes_.back().kind == Kind::constant && (nodes_.back().first != 0) == value;
}

BooleanExpression BooleanExpression::join(Kind kind, const BooleanExpression& a,
                                          const BooleanExpression& b) {
  BooleanExpression joined = a;
  const int shift = static_cast<int>(a.nodes_.size());
  for (Node node : b.nodes_) {
    if (node.kind != Kind::constant && node.kind != Kind::variable) {
      node.first += shift;
      node.second += shift;
    }
    joined.nodes_.push_back(node);
  }
  joined.nodes_.push_back({kind, shift - 1, static_cast<int>(joined.nodes_.size()) - 1});
  return joined;
}

BooleanExpression operator&(const BooleanExpression& a, const BooleanExpression& b) {
  if (a.is_constant(false) || b.is_constant(true)) return a;
  if (b.is_constant(false) || a.is_constant(true)) return b;
  return BooleanExpression::join(BooleanExpression::Kind::conjunction, a, b);
}

BooleanExpression operator|(const BooleanExpression& a, const BooleanExpression& b) {
  if (a.is_constant(true) || b.is_constant(false)) return a;
  if (b.is_constant(true) || a.is_constant(false)) return b;
  return BooleanExpression::join(BooleanExpression::Kind::disjunction, a, b);
}

BooleanExpression operator!(const BooleanExpression& a) {
  if (a.is_constant(false)) return BooleanExpression::constant(true);
  if (a.is_constant(true)) return BooleanExpression::constant(false);
  BooleanExpression negated = a;
  const auto& root = negated.nodes_.back();
  if (root.kind == BooleanExpression::Kind::negation &&
      root.first == static_cast<int>(negated.nodes_.size()) - 2) {
    negated.nodes_.pop_back();
    return negated;
  }
  negated.nodes_.push_back(
      {BooleanExpression::Kind::negation, static_cast<int>(negated.nodes_.size()) - 1, 0});
  return negated;
}

BooleanExpression operator^(const BooleanExpression& a, const BooleanExpression& b) {
  return (a & (!b)) | ((!a) & b);
}

}  // namespace rfm
