#pragma once

#include <span>
#include <string>

#include "core/field.hpp"

namespace rfm {

/// Why a field has no finite value at a point: the innermost operation that fails on finite
/// arguments, with its values and as a formula,
///
///     sqrt(-0.25) in sqrt(x - 1)            1 / 0 in 1/(x - 2)
///     log(-0.5) in log(x)                   the field [sampled field] outside its region [0, 1]
///
/// Empty if the value is finite. Branches of `if` that are not taken are not blamed; derivatives
/// are looked for where they are used. Time and memory are linear in the size of the graph: every
/// node is evaluated once. Parameters beyond those given count as not finite.
std::string diagnose(const Field& field, const Point& point, int dimension, double time = 0,
                     std::span<const double> parameters = {});

/// ": " and the diagnosis, or nothing: for the end of a message.
std::string diagnosis_suffix(const Field& field, const Point& point, int dimension, double time = 0,
                             std::span<const double> parameters = {});

/// A point as messages show it, "(0.5, -1)", with ten digits.
std::string point_text(const Point& point, int dimension);

}  // namespace rfm
