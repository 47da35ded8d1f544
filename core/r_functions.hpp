#pragma once

#include <span>
#include <vector>

#include "core/boolean.hpp"
#include "core/field.hpp"
#include "core/r_systems.hpp"
#include "core/region.hpp"

namespace rfm {

// R-functions: real functions whose sign is a Boolean function (the companion) of the signs of
// their arguments. Next to the boundary all keep their relative accuracy: differences of nearly
// equal numbers are computed in the stable form (r_rules.hpp). All throw `InvalidArgument` when the
// parameter of `system` is out of range.

/// Intersection {x ≥ 0} ∩ {y ≥ 0}: positive exactly where both arguments are positive, and zero on
/// its boundary.
Field conjunction(const Field& x, const Field& y, const RSystem& system = RAlpha{});
/// Union {x ≥ 0} ∪ {y ≥ 0}, by De Morgan's law: x ∨ y = −(−x ∧ −y).
Field disjunction(const Field& x, const Field& y, const RSystem& system = RAlpha{});
/// Complement {x ≤ 0}: −x.
Field negation(const Field& x);
/// Where exactly one is positive: (¬x ∧ y) ∨ (x ∧ ¬y). For R₀ in closed form as
/// −2xy / (√(x² + y² − xy) + √(x² + y²)).
Field exclusive_or(const Field& x, const Field& y, const RSystem& system = RAlpha{});
/// Where x ≥ 0 implies y ≥ 0: ¬x ∨ y.
Field implication(const Field& x, const Field& y, const RSystem& system = RAlpha{});
/// Sheffer's stroke ¬(x ∧ y), of which every other Boolean function can be made.
Field sheffer_stroke(const Field& x, const Field& y, const RSystem& system = RAlpha{});

/// Conjunction and disjunction of any number of fields, as a balanced tree in the order given
/// (systems other than R₁ are not associative); of none, 1 and −1.
Field conjunction(const std::vector<Field>& fields, const RSystem& system = RAlpha{});
Field disjunction(const std::vector<Field>& fields, const RSystem& system = RAlpha{});

/// The R-function of any Boolean function (its companion): R-functions of `system` substituted for
/// the operations of `expression`, field v for variable v (theorem 3 of Shapiro 2007). A field may
/// occur several times; where the expression is minimal it does so least often. Texts and truth
/// tables become expressions by `BooleanText::expression` and `minimal_expression`. Throws
/// `InvalidArgument` if there are fewer fields than variables.
Field r_function(const BooleanExpression& expression, std::span<const Field> arguments,
                 const RSystem& system = RAlpha{});

/// A Boolean expression over primitives with R-functions substituted for its operations; variable v
/// becomes the normalised function of primitive v.
Field implicit(const BooleanExpression& expression, const Region& region,
               const RSystem& system = RAlpha{});
/// The whole region as one function, of its expression without redundancy: ≥ 0 exactly on it, for
/// membership, pictures and composition. Zero on the boundary, and at irregular places
/// (core/regularity.hpp).
Field implicit(const Region& region, const RSystem& system = RAlpha{});

}  // namespace rfm
