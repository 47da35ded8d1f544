#pragma once

#include "core/boolean.hpp"

namespace rfm {

/// The Boolean derivative of an expression by a variable, true where the variable decides:
/// Φ[v := true] xor Φ[v := false]. Where v occurs in one argument only the rules
///
///     (A & B)' = A' & B,    (A | B)' = A' & !B,    (!A)' = A'
///
/// hold, and the derivative is a product in which v and the rest of A occur no more than needed:
/// its R-function is negative also where A and B vanish together, and that of the exclusive or is
/// 0.
BooleanExpression boolean_derivative(const BooleanExpression& expression, int variable);

}  // namespace rfm
