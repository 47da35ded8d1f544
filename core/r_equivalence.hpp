#pragma once

#include <vector>

#include "core/field.hpp"

namespace rfm {

/// R-equivalence x ~p y = xy (|x|ᵖ + |y|ᵖ)^{−1/p}, eq. (5.3) of Shapiro (2007), p from 1 to 64:
/// zero where x or y is, positive where their signs agree. It joins functions of pieces of a
/// boundary into one: with x, y ≥ 0 the zero set is the union. On x = 0 ≠ y it is x + O(x^{p+1}),
/// so that it preserves normalisation to order p. At x = y = 0 derivatives are 0 by convention.
/// Throws `InvalidArgument` when p is out of range.
Field equivalence(const Field& x, const Field& y, int p = 2);
/// The same of any number of fields, [Σ |ωᵢ|⁻ᵖ]^(−1/p) with the product of their signs: since ~p is
/// associative the closed form is evaluated as a balanced tree, which has jets where one of them is
/// 0 and neither overflows nor loses more digits than the logarithm of their number. Throws
/// `InvalidArgument` for none.
Field equivalence(const std::vector<Field>& fields, int p = 2);

}  // namespace rfm
