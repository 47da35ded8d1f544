#pragma once

#include <string>
#include <vector>

#include "core/combine_rule.hpp"
#include "core/region.hpp"

namespace rfm {

/// Which rule made a part of a weight, and how smooth that part is, in words.
struct WeightPart {
  std::string formula;
  std::string rule;
  std::string smoothness;
};

/// A weight: zero on the boundary, positive inside.
struct Weight {
  Field function;
  /// How it is built, in words of the primitives' names: `outer * -inner`, `r0_and(a, b) * c`.
  std::string formula;
  /// The whole first where it joins several parts.
  std::vector<WeightPart> parts = {};
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
/// box of the region); conjuncts that must not multiply are gathered in one R₀-conjunction. Of more
/// than six factors those whose boundaries do not meet are gathered, too.
/// Conjuncts whose zero set does not meet the closed region are left out.
///
/// Products use the primitives' `level` (polynomials where there are any), R-functions their
/// normalised `function`. `options` choose another rule, and shape the functions of primitives.
///
/// Throws `InvalidArgument` where options are out of range or name no primitive, a cap is not
/// proved positive in the region, or the pieces of a corner scale cross inside the region (where
/// the weight would be zero).
Weight weight(const RegionEvaluator& region, const Box& bounds, const WeightOptions& options = {});

/// The weight of an expression over the primitives of `region` other than its own: the product or
/// R₀-function that vanishes on the pieces of the boundary that `expression` names.
Weight weight(const BooleanExpression& expression, const RegionEvaluator& region, const Box& bounds,
              const WeightOptions& options = {});

/// The R₀-functions, normalised, of the groups of conjuncts that the weight of `expression` is the
/// product of. (Of a convex polygon with hundreds of edges a product of the functions of all would
/// vanish to rounding all over the region.)
std::vector<Weight> normalized_factors(const BooleanExpression& expression,
                                       const RegionEvaluator& region, const Box& bounds);

}  // namespace rfm
