#include "core/boolean_derivative.hpp"

#include <vector>

namespace rfm {
namespace {

using Kind = BooleanExpression::Kind;

class Derivative {
 public:
  Derivative(const BooleanExpression& expression, int variable)
      : nodes_(expression.nodes()), variable_(variable), depends_(nodes_.size()) {
    for (std::size_t i = 0; i < nodes_.size(); ++i) {
      const auto& [kind, first, second] = nodes_[i];
      if (kind == Kind::variable)
        depends_[i] = first == variable;
      else if (kind != Kind::constant)
        depends_[i] = depends_[first] || (kind != Kind::negation && depends_[second]);
    }
  }

  BooleanExpression of(int node) const {
    if (!depends_[node]) return BooleanExpression::constant(false);
    const auto& [kind, first, second] = nodes_[node];
    if (kind == Kind::variable) return BooleanExpression::constant(true);
    if (kind == Kind::negation) return of(first);
    if (depends_[first] && depends_[second]) {
      const BooleanExpression both = at(node);
      return both.restricted(variable_, true) ^ both.restricted(variable_, false);
    }
    const int inner = depends_[first] ? first : second, other = depends_[first] ? second : first;
    return of(inner) & (kind == Kind::conjunction ? at(other) : !at(other));
  }

 private:
  BooleanExpression at(int node) const { return BooleanExpression::of_nodes(nodes_, node); }

  const std::vector<BooleanExpression::Node>& nodes_;
  int variable_;
  std::vector<bool> depends_;
};

}  // namespace

BooleanExpression boolean_derivative(const BooleanExpression& expression, int variable) {
  return Derivative(expression, variable).of(static_cast<int>(expression.nodes().size()) - 1);
}

}  // namespace rfm
