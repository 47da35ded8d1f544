#include "core/boolean_implications.hpp"

#include <algorithm>

#include "core/error.hpp"

namespace rfm {

using Kind = BooleanExpression::Kind;

Implications::Implications(std::span<const int> variables) {
  if (variables.size() > most_variables)
    throw InvalidArgument("implications are among 64 variables at most");
  implied_.resize(2 * variables.size());
  for (std::size_t i = 0; i < implied_.size(); ++i) implied_[i].set(i);
  for (std::size_t i = 0; i < variables.size(); ++i) {
    const auto number = static_cast<std::size_t>(variables[i]);
    if (place_.size() <= number) place_.resize(number + 1, -1);
    place_[number] = static_cast<int>(i);
  }
}

void Implications::add(int first, bool of_first, int second, bool of_second) {
  implied_[literal(first, of_first)].set(literal(second, of_second));
  implied_[literal(second, !of_second)].set(literal(first, !of_first));
}

/// An expression rewritten from the root down, with what is known where each of its parts matters.
class ImpliedSigns {
 public:
  ImpliedSigns(const BooleanExpression& expression, const Implications& implications)
      : nodes_(expression.nodes()), implications_(implications) {}

  BooleanExpression run() { return rewritten(root(), {}); }
  bool is_too_long() const { return visits_ > most_visits; }

 private:
  using Literals = Implications::Literals;
  static constexpr int most_visits = 2000;

  int root() const { return static_cast<int>(nodes_.size()) - 1; }

  // The literal that a node is; −1 if it is none, or of a variable of which nothing is known.
  int literal_at(int node) const {
    const bool negated = nodes_[node].kind == Kind::negation;
    const auto& leaf = nodes_[negated ? nodes_[node].first : node];
    if (leaf.kind != Kind::variable) return -1;
    const auto& place = implications_.place_;
    const auto number = static_cast<std::size_t>(leaf.first);
    if (number >= place.size() || place[number] < 0) return -1;
    return Implications::literal(place[number], !negated);
  }
  static int opposite(int literal) { return literal ^ 1; }

  BooleanExpression leaf(int node) const {
    if (nodes_[node].kind == Kind::constant)
      return BooleanExpression::constant(nodes_[node].first != 0);
    if (nodes_[node].kind == Kind::negation) return !leaf(nodes_[node].first);
    return BooleanExpression::variable(nodes_[node].first);
  }

  void list_operands(int node, Kind kind, std::vector<int>& operands) const {
    if (nodes_[node].kind != kind) {
      operands.push_back(node);
      return;
    }
    list_operands(nodes_[node].first, kind, operands);
    list_operands(nodes_[node].second, kind, operands);
  }

  BooleanExpression rewritten(int node, const Literals& known) {
    ++visits_;
    const Kind kind = nodes_[node].kind;
    if (is_too_long()) return leaf(0);
    if (kind == Kind::conjunction || kind == Kind::disjunction) return chain(node, known);
    const int literal = literal_at(node);
    if (literal >= 0 && known[literal]) return BooleanExpression::constant(true);
    if (literal >= 0 && known[opposite(literal)]) return BooleanExpression::constant(false);
    return leaf(node);
  }

  // The others of a conjunction matter where an operand is true, those of a disjunction where it is
  // false.
  BooleanExpression chain(int node, Literals known) {
    const Kind kind = nodes_[node].kind;
    const bool conjunction = kind == Kind::conjunction;
    std::vector<int> operands, literals, others;
    list_operands(node, kind, operands);
    for (const int operand : operands) {
      const int literal = literal_at(operand);
      if (literal < 0) {
        others.push_back(operand);
        continue;
      }
      const int assumed = conjunction ? literal : opposite(literal);
      if (known[assumed]) continue;
      if (known[opposite(assumed)]) return BooleanExpression::constant(!conjunction);
      known |= implications_.implied_[assumed];
      literals.push_back(operand);
    }
    // What comes later may imply what came before.
    for (std::size_t i = 0; i < literals.size();) {
      const auto is_implied_by = [&](int other) {
        if (other == literals[i]) return false;
        const int assumed = literal_at(literals[i]), by = literal_at(other);
        return conjunction ? implications_.implied_[by][assumed]
                           : implications_.implied_[opposite(by)][opposite(assumed)];
      };
      if (std::ranges::any_of(literals, is_implied_by))
        literals.erase(literals.begin() + static_cast<std::ptrdiff_t>(i));
      else
        ++i;
    }
    BooleanExpression result = BooleanExpression::constant(conjunction);
    const auto join = [&](const BooleanExpression& operand) {
      result = conjunction ? result & operand : result | operand;
    };
    for (const int literal : literals) join(leaf(literal));
    for (const int other : others) join(rewritten(other, known));
    return result;
  }

  const std::vector<BooleanExpression::Node>& nodes_;
  const Implications& implications_;
  int visits_ = 0;
};

BooleanExpression with_implications(const BooleanExpression& expression,
                                    const Implications& implications) {
  BooleanExpression result = expression.negations_at_leaves();
  for (;;) {
    // What is left of a part may be a literal, which tells something of the parts beside it.
    ImpliedSigns signs(result, implications);
    BooleanExpression shorter = signs.run();
    if (signs.is_too_long()) return result;
    if (shorter.nodes().size() >= result.nodes().size()) return result;
    result = std::move(shorter);
  }
}

}  // namespace rfm
