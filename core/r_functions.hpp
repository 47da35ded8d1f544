#pragma once

#include <string>
#include <variant>

#include "core/boolean.hpp"
#include "core/field.hpp"
#include "core/region.hpp"

namespace rfm {

/// x ∧ y = (x + y − √(x² + y² − 2αxy)) / (1 + α), −1 < α ≤ 1; α = 0 is R₀, α = 1 is min (R₁).
struct RAlpha {
  double alpha = 0;
};
/// x ∧ y = x + y − (xᵖ + yᵖ)^(1/p), p even; x + O(xᵖ) on the face x = 0: normalised to order p − 1.
struct Rp {
  int p = 4;
};
/// A system of R-functions: V. L. Rvachev (1982); V. Shapiro, Semi-analytic geometry with
/// R-functions, Acta Numerica 16 (2007), §3.2.
using RSystem = std::variant<RAlpha, Rp>;

/// Intersection {x ≥ 0} ∩ {y ≥ 0}: positive exactly where both arguments are positive, and zero on
/// its boundary. Next to the boundary Rα keeps its relative accuracy (there it is computed as
/// 2xy / (x + y + √…)), Rp for p > 2 only its absolute one. Throws `InvalidArgument` when the
/// parameter of `system` is out of range.
Field conjunction(const Field& x, const Field& y, const RSystem& system = RAlpha{});
/// Union {x ≥ 0} ∪ {y ≥ 0}, by De Morgan's law: x ∨ y = −(−x ∧ −y).
Field disjunction(const Field& x, const Field& y, const RSystem& system = RAlpha{});

/// A Boolean expression over primitives with R-functions substituted for its operations; variable v
/// becomes the normalised function of primitive v.
Field implicit(const BooleanExpression& expression, const Region& region,
               const RSystem& system = RAlpha{});
/// The whole region as one function: ≥ 0 exactly on it, for membership, pictures and composition.
Field implicit(const Region& region, const RSystem& system = RAlpha{});

}  // namespace rfm
