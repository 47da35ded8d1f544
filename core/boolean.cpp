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

BooleanExpression BooleanExpression::restricted(int number, bool value) const {
  std::vector<BooleanExpression> built;
  built.reserve(nodes_.size());
  for (const Node& node : nodes_) {
    switch (node.kind) {
      case Kind::constant:
        built.push_back(constant(node.first != 0));
        break;
      case Kind::variable:
        built.push_back(node.first == number ? constant(value) : variable(node.first));
        break;
      case Kind::negation:
        built.push_back(!built[node.first]);
        break;
      case Kind::conjunction:
        built.push_back(built[node.first] & built[node.second]);
        break;
      case Kind::disjunction:
        built.push_back(built[node.first] | built[node.second]);
        break;
    }
  }
  return built.back();
}

BooleanExpression BooleanExpression::renamed(std::span<const int> new_number) const {
  BooleanExpression expression = *this;
  for (Node& node : expression.nodes_)
    if (node.kind == Kind::variable) node.first = new_number[node.first];
  return expression;
}

BooleanExpression BooleanExpression::negations_at_leaves() const {
  // For every node the expression itself and its negation, negations only on variables.
  std::vector<std::array<BooleanExpression, 2>> built;
  built.reserve(nodes_.size());
  for (const Node& node : nodes_) {
    switch (node.kind) {
      case Kind::constant:
        built.push_back({constant(node.first != 0), constant(node.first == 0)});
        break;
      case Kind::variable:
        built.push_back({variable(node.first), !variable(node.first)});
        break;
      case Kind::negation:
        built.push_back({built[node.first][1], built[node.first][0]});
        break;
      case Kind::conjunction:
        built.push_back({built[node.first][0] & built[node.second][0],
                         built[node.first][1] | built[node.second][1]});
        break;
      case Kind::disjunction:
        built.push_back({built[node.first][0] | built[node.second][0],
                         built[node.first][1] & built[node.second][1]});
        break;
    }
  }
  return built.back()[0];
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
