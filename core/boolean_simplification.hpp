#pragma once

#include <span>

#include "core/boolean.hpp"

namespace rfm {

/// The expression where variables of known sign are constants, propagated: of the others those
/// remain on which the value may depend, as `BooleanExpression::mark_relevant` says, under their
/// numbers. Where a few of many primitives are undecided it is as short as they are few.
BooleanExpression with_known_signs(const BooleanExpression& expression,
                                   std::span<const Truth> signs);

/// The expression without what does not change it as a combination of *closed* sets: constants,
/// repeated operands (a & a), absorbed ones (a & (a | b) = a), operands that another one contains
/// ((a | b) & (a | b | c) = a | b). Negations end up at the variables (De Morgan); what remains
/// keeps its order and grouping. It pays: an argument that occurs once keeps its normalisation in
/// an R-function (theorem 4 of Shapiro 2007), while a ∧₀ a = (2 − √2) a.
///
/// Not applied are laws of Boolean algebra that fail for closed sets: a & !a is the boundary of a,
/// not the empty set, and a | !a has a zero there. `irregularities` (core/regularity.hpp) finds
/// those. The result need not be the shortest: see core/boolean_minimization.hpp.
BooleanExpression without_redundancy(const BooleanExpression& expression);

/// Intersections and unions exchanged, also true and false: what x ↦ ¬Φ(¬x) is.
BooleanExpression dual(const BooleanExpression& expression);

/// ¬Φ with negations at the variables: the formal complement. Its R-function is −ω_Φ, so that it
/// removes no zeros of ω_Φ; Shapiro (2007, §5.3) calls it the dual.
BooleanExpression formal_complement(const BooleanExpression& expression);

}  // namespace rfm
