#pragma once

#include <string>
#include <vector>

#include "core/region.hpp"

namespace rfm {

/// How the Boolean expression of a region becomes the function that multiplies Ψ.
enum class CombineRule {
  automatic,  ///< the smoothest that is right, see `weight`
  r0,         ///< R₀-functions throughout
  r1,         ///< min and max: for comparison only, first order at best
  product     ///< a product of all conjuncts, whatever the angles
};

/// A weight: zero on the boundary, positive inside.
struct Weight {
  Field function;
  /// How it is built, in words of the primitives' names: `outer * -inner`, `r0_and(a, b) * c`.
  std::string formula;
};

/// `expression` without the primitives whose sign is the same all over `bounds`, which is proved.
BooleanExpression simplified(const BooleanExpression& expression, const RegionEvaluator& region,
                             const Box& bounds);

/// The operands of an expression's outermost conjunction (one operand if there is none).
std::vector<BooleanExpression> conjuncts(const BooleanExpression& expression);

/// What multiplies Ψ in a solution structure. Its smoothness decides accuracy, and two cases
/// differ: where boundary pieces do not meet in the closed region, or meet at an interior angle of
/// at most 90°, the *product* of their functions is as smooth as they are and u/ω stays bounded; at
/// larger convex angles u/ω is unbounded with a product, and an R₀-conjunction is better; at
/// reentrant corners a disjunction is needed, and what stands below it is R₀ throughout.
/// `automatic` decides pair by pair of conjuncts, by branch and bound over `bounds` (the bounding
/// box of the region); conjuncts that must not multiply are gathered in one R₀-conjunction.
/// Conjuncts whose zero set does not meet the closed region are left out.
///
/// Products use the primitives' `level` (polynomials where there are any), R-functions their
/// normalised `function`.
Weight weight(const RegionEvaluator& region, const Box& bounds,
              CombineRule rule = CombineRule::automatic);

/// The weight of an expression over the primitives of `region` other than its own: the product or
/// R₀-function that vanishes on the pieces of the boundary that `expression` names.
Weight weight(const BooleanExpression& expression, const RegionEvaluator& region, const Box& bounds,
              CombineRule rule = CombineRule::automatic);

}  // namespace rfm
