#include "core/same_sign.hpp"

#include <optional>
#include <utility>

namespace rfm {
namespace {

// 1, −1, or 0 if the sign is not the same everywhere, or not known to be.
int sign_everywhere(const Field& f) {
  const Field::Node& node = f.node();
  switch (node.operation) {
    case Operation::constant:
      return node.number > 0 ? 1 : node.number < 0 ? -1 : 0;
    case Operation::negate:
      return -sign_everywhere(node.arguments[0]);
    case Operation::exp:
    case Operation::cosh:
      return node.defined_everywhere ? 1 : 0;
    default:
      return 0;
  }
}

bool is_increasing_and_odd(const Field::Node& node) {
  switch (node.operation) {
    case Operation::cbrt:
    case Operation::sinh:
    case Operation::asinh:
    case Operation::tanh:
    case Operation::atan:
    case Operation::erf:
      return true;
    case Operation::integer_power:
      return node.number > 0 && static_cast<long>(node.number) % 2 == 1;
    default:
      return false;
  }
}

// What a node is a multiple of, and whether its sign is the opposite of that.
std::optional<std::pair<Field, bool>> without_outermost(const Field::Node& node) {
  if (node.operation == Operation::negate) return {{node.arguments[0], true}};
  if (is_increasing_and_odd(node)) return {{node.arguments[0], false}};
  if (node.operation == Operation::multiply)
    for (const int factor : {0, 1})
      if (const int sign = sign_everywhere(node.arguments[factor]); sign != 0)
        return {{node.arguments[1 - factor], sign < 0}};
  if (node.operation == Operation::divide)
    if (const int sign = sign_everywhere(node.arguments[1]); sign != 0)
      return {{node.arguments[0], sign < 0}};
  return std::nullopt;
}

}  // namespace

Field simplest_of_same_sign(const Field& f) {
  Field best = f, inner = f;
  bool opposite = false;
  while (const auto next = without_outermost(inner.node())) {
    inner = next->first;
    opposite ^= next->second;
    if (inner.is_constant()) return f;
    // One negation costs less than what it stands for.
    best = opposite ? -inner : inner;
  }
  return best;
}

}  // namespace rfm
