#pragma once

#include "core/field.hpp"

namespace rfm {

// Conditional R-functions: functions that are R-functions where their arguments satisfy a condition
// only, and simpler or smoother than R-functions for it (V. L. Rvachev 1982; V. Shapiro, Acta
// Numerica 16 (2007), §3.4). Expressions minimised with don't-cares (core/boolean_minimization.hpp)
// are others: right for the combinations of signs that occur.

/// x + y − √(x² + y² + s), eq. (3.7) with s₁ = −1 and the misprinted power mended: the
/// R₀-conjunction where s = 0, and analytic where s > 0, also at x = y = 0. Condition: s ≥ 0, and s
/// = 0 wherever the sign or the zeros matter; where s > 0 the zero set recedes to {2xy = s} inside
/// the conjunction.
Field conditional_conjunction(const Field& x, const Field& y, const Field& s);
/// x + y + √(x² + y² + s): the R₀-disjunction where s = 0; its zero set advances where s > 0.
Field conditional_disjunction(const Field& x, const Field& y, const Field& s);

/// xy / √(x² + y²): a conjunction where x and y are not both negative, there normalised to order 2
/// (x ∧ y = x − x³/2y² + …, against order 1 of R₀): what a product of two conjuncts is inside a
/// region of which no exterior point is outside of both. 0 with derivatives 0 at x = y = 0.
Field quotient_conjunction(const Field& x, const Field& y);

}  // namespace rfm
