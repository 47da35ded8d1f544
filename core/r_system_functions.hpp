#pragma once

#include "core/expression.hpp"

namespace rfm {

/// Adds conjunction and disjunction of the systems of R-functions that are no operations of the
/// table, under the names that formulas of weights are written with (core/r_systems.hpp):
///
///     r0m_and(x, y, m)   ralpham_and(x, y, alpha, m)   rcm_and(x, y, m)
///     ralpha_field_and(x, y, alpha), alpha a function
///
/// and the same with `_or`.
void define_r_functions(ExpressionScope& scope);

}  // namespace rfm
