#pragma once

#include "core/combine_rule.hpp"

namespace rfm {

// Functions with the zeros of ω and its slope on them (Shapiro 2007, §7.3): they control how large
// a weight becomes inside.

/// ω / (1 + |βω|^α), as ω for ω → 0: normalised to order min(k, α) where ω is to order k (α a whole
/// number). Largest value for α > 1, at |βω| = (α − 1)^{−1/α}; for α = 1 it tends to 1/β. Throws
/// `InvalidArgument` unless α ≥ 1 and β > 0.
Field saturate(const Field& omega, const Saturation& saturation);

/// ω / √(1 + (ω/L)²): tends to L where ω is large, and is ω + O(ω³), normalised to order 2 where ω
/// is. Distances in transfinite interpolation should not exceed the size of the domain: of large
/// numbers, one set of data changes into another within a thin layer, and digits cancel. Throws
/// `InvalidArgument` unless L > 0.
Field level_off(const Field& omega, double length);

/// exp(−(ω/w)⁴): 1 + O(ω⁴) where ω = 0, below 10⁻¹⁰ from ω = 2.2 w on, analytic: keeps corrections
/// of solution structures near the boundary. Throws `InvalidArgument` unless w > 0.
Field cutoff(const Field& omega, double width);

/// ω ∧₀ γ, below γ where γ > 0 and as ω for ω → 0: normalised to order 1 where ω is.
Field cap(const Field& omega, const Field& gamma);

/// 1 − (1 − ω/w)₊ᵖ: 1 for ω ≥ w, of slope p/w where ω = 0, p − 1 times differentiable: the weight
/// of web-splines (K. Höllig, Finite Element Methods with B-Splines, 2003). Not normalised, so that
/// products of such functions are 1 away from the boundary. Throws `InvalidArgument` unless w > 0
/// and 1 ≤ p ≤ 16.
Field plateau(const Field& omega, const PlateauRule& rule);

}  // namespace rfm
