#pragma once

#include "core/field.hpp"

namespace rfm {

/// The part of {γ = 0} inside {λ ≥ 0} as a function that is zero exactly there and positive
/// elsewhere, normalised where γ is, on all of the part but its ends:
///
///     ω = √(γ² + (√(λ² + γ⁴) − λ)² / 4),
///
/// eq. (5.1) of Shapiro (2007) (Sheiko 1982). Twice differentiable across {λ = 0}. Computed for
/// λ > 0 as |γ| √(1 + γ⁶ / (4 (√(λ² + γ⁴) + λ)²)), in which nothing cancels. On the part itself ω
/// has a kink, and its derivatives are those of the side γ ≥ 0.
///
/// λ² + γ⁴ is a sum of lengths to different powers. Both are taken in units of `length`, that of
/// the part, so that the function of a part twice as large is twice as large.
Field trim(const Field& gamma, const Field& lambda, double length = 1);

/// The same with the sign of γ where λ > 0: smooth across the part, so that normal derivatives may
/// be taken at points of it that rounding puts on either side of γ = 0. For use where γ ≥ 0 inside:
/// beyond the ends, where λ ≤ 0, it is `trim`, and on {λ = 0, γ < 0} it jumps.
Field trim_from_inside(const Field& gamma, const Field& lambda, double length = 1);

/// The same of γ² ≥ 0 instead of γ: for curves in space, where γ is the distance from a curve and
/// only its square is smooth.
Field trim_of_square(const Field& square, const Field& lambda, double length = 1);

}  // namespace rfm
