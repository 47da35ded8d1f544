#pragma once

#include <unordered_map>

#include "core/field.hpp"

namespace rfm {

/// Differentiates expressions node by node: the derivative is again an expression, which shares the
/// nodes of the original. Exact, like jets, and for what jets are not taken in: parameters, and
/// coordinates that a tape holds. A partial derivative within the expression stays one, of the
/// differentiated function. Derivatives that do not exist are finite by the same convention as in
/// core/jet.hpp: singular ones are 0, at corners that of the branch taken. Where a function is not
/// defined its derivative is not either: ∂(x + log y)/∂x is 1 + 0 (x + log y).
///
/// The derivatives that were made are kept, so that one object serves many expressions that share
/// nodes. Graphs may be arbitrarily deep.
class GraphDerivative {
 public:
  /// `variable` is a coordinate or a parameter, else `InvalidArgument` is thrown.
  explicit GraphDerivative(const Field& variable);
  /// The derivative of a sampled field along a coordinate is one of its derivatives, sampled.
  Field of(const Field& f);
  /// The same where f is defined: elsewhere it may be a number, as 1 for x + log y. Zeros are
  /// constants, so that matrices of derivatives stay sparse; for what looks at f itself too.
  Field where_defined(const Field& f);

 private:
  struct Known {
    Field node, derivative;  // the node is kept alive: its address is the key
    bool tells;              // whether the derivative is no number wherever the node is none
  };
  Known of_node(const Field& f) const;
  Field of_source(const Field& f) const;
  const Known& known(const Field& f) const { return known_.at(&f.node()); }
  const Known& find(const Field& f);

  Field variable_;
  std::unordered_map<const Field::Node*, Known> known_;
};

/// ∂f/∂p, p a parameter or a coordinate. Repeated for higher and mixed derivatives.
///
///     const Field radius = parameter(0);
///     derivative_with_respect_to(radius * radius - x * x, radius)       // 2 radius
Field derivative_with_respect_to(const Field& f, const Field& variable);

}  // namespace rfm
