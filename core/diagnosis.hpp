#pragma once

#include <string>

#include "core/field.hpp"

namespace rfm {

/// Why a field has no finite value at a point: the innermost operation that fails on finite
/// arguments, as `sqrt(-0.25)` or `1 / 0`. Empty if the value is finite. Branches of `if` that are
/// not taken are not blamed. For messages: every step evaluates a sub-expression anew.
std::string diagnose(const Field& field, const Point& point, int dimension);

}  // namespace rfm
