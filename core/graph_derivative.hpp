#pragma once

#include <unordered_map>

#include "core/field.hpp"

namespace rfm {

/// Differentiates expressions node by node: the derivative is again an expression, which shares the
/// nodes of the original. Exact, like jets, and for what jets are not taken in: parameters, and
/// coordinates that a tape holds. A partial derivative within the expression stays one, of the
/// differentiated function. Derivatives that do not exist are finite by the same convention as in
/// core/jet.hpp: singular ones are 0, at corners that of the branch taken. Where an operation on
/// the variable is not defined its derivative is not either; what does not depend on the variable
/// is not looked at: ∂(x + log y)/∂x = 1 for every y.
///
/// The derivatives that were made are kept, so that one object serves many expressions that share
/// nodes. Graphs may be arbitrarily deep.
class GraphDerivative {
 public:
  /// `variable` is a coordinate or a parameter, else `InvalidArgument` is thrown.
  explicit GraphDerivative(const Field& variable);
  /// The derivative of a sampled field along a coordinate is one of its derivatives, sampled.
  Field of(const Field& f);

 private:
  struct Known {
    Field node, derivative;  // the node is kept alive: its address is the key
  };
  Field of_node(const Field& f) const;
  Field of_source(const Field& f) const;
  const Field& known(const Field& f) const { return known_.at(&f.node()).derivative; }

  Field variable_;
  std::unordered_map<const Field::Node*, Known> known_;
};

/// ∂f/∂p, p a parameter or a coordinate. Repeated for higher and mixed derivatives.
///
///     const Field radius = parameter(0);
///     derivative_with_respect_to(radius * radius - x * x, radius)       // 2 radius
Field derivative_with_respect_to(const Field& f, const Field& variable);

}  // namespace rfm
