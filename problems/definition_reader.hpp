#pragma once

#include "problems/problem.hpp"
#include "problems/value_reader.hpp"

namespace rfm {

/// Reads `parameters`, `fields` and `functions` into the problem and the scopes of `values`, whose
/// `scope` must already hold what every formula may name. Parameters may use each other in any
/// order; definitions that use themselves, however indirectly, are mistakes that name the cycle.
void read_definitions(const DocumentNode& root, ValueReader& values, Problem& problem);

/// Checks every field and function as a formula, with stand-ins for what is known only later. To be
/// called when `omega(name)` has a meaning.
void check_definitions(const DocumentNode& root, const ValueReader& values);

}  // namespace rfm
