#pragma once

#include <vector>

#include "core/field.hpp"
#include "solution_structures/condition_part.hpp"

namespace rfm {

/// The generalised Taylor polynomial f₀* + Σ_k f_k* ω^k / k!, eq. (7.5) of Shapiro (2007): its
/// value where ω = 0 is f₀ and its k-th derivative along the straight inward normal f_k, k = 1 … m.
/// ω is normalised to order m (`normalize`), and f* = f(x − ω∇ω); the last f_m is not
/// differentiated and stays as it is. The exponent is m + 1. Throws `InvalidArgument` without data.
ConditionPart taylor_part(const std::vector<Field>& inward_derivatives, const Field& omega,
                          int dimension);

}  // namespace rfm
