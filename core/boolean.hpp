#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/interval.hpp"

namespace rfm {

/// A Boolean expression over variables 0 … n − 1 (the signs of primitives), as a list of nodes in
/// which arguments come before their users; the last node is the root.
class BooleanExpression {
 public:
  enum class Kind : std::uint8_t { constant, variable, negation, conjunction, disjunction };
  struct Node {
    Kind kind;
    int first = 0;   ///< value of a constant, number of a variable, or first argument (a node)
    int second = 0;  ///< second argument (a node)
  };

  static BooleanExpression constant(bool value);
  static BooleanExpression variable(int number);
  /// What `nodes[root]` stands for, without the nodes that it does not use; arguments come before
  /// their users.
  static BooleanExpression of_nodes(const std::vector<Node>& nodes, int root);

  /// Number of variables: one more than the largest that occurs.
  int variable_count() const;
  const std::vector<Node>& nodes() const { return nodes_; }

  /// Value in three-valued logic; `signs[v]` is the truth of variable v.
  Truth evaluate(std::span<const Truth> signs) const;
  bool evaluate(std::span<const bool> signs) const;
  /// Marks in `relevant` (one entry per variable) every variable on which the value may still
  /// depend when the others are as in `signs`.
  void mark_relevant(std::span<const Truth> signs, std::span<bool> relevant) const;

  /// The expression with `number` replaced by a constant, constants propagated.
  BooleanExpression restricted(int number, bool value) const;
  /// The same expression with variable v renamed to `new_number[v]`.
  BooleanExpression renamed(std::span<const int> new_number) const;
  /// Negations pushed down to the variables (De Morgan).
  BooleanExpression negations_at_leaves() const;
  /// The same without negations: ¬v becomes variable `variables` + v, for v < `variables`.
  BooleanExpression monotone_form(int variables) const;
  bool is_constant(bool value) const;

 private:
  friend BooleanExpression operator&(const BooleanExpression&, const BooleanExpression&);
  friend BooleanExpression operator|(const BooleanExpression&, const BooleanExpression&);
  friend BooleanExpression operator!(const BooleanExpression&);
  static BooleanExpression join(Kind kind, const BooleanExpression& a, const BooleanExpression& b);
  std::vector<Node> nodes_;
};

/// Constants are absorbed: x & true = x, x | true = true.
BooleanExpression operator&(const BooleanExpression& a, const BooleanExpression& b);
BooleanExpression operator|(const BooleanExpression& a, const BooleanExpression& b);
BooleanExpression operator!(const BooleanExpression& a);
/// Exclusive or: (a & !b) | (!a & b).
BooleanExpression operator^(const BooleanExpression& a, const BooleanExpression& b);

}  // namespace rfm
