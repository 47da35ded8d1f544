#pragma once

#include "problems/problem.hpp"
#include "problems/value_reader.hpp"

namespace rfm {

/// Reads what an entry of `conditions` prescribes: its kind, its formulas by key, and what of a
/// condition only some physics have. What is wrong is added to the mistakes of `values`.
void read_condition_data(const DocumentNode& node, ValueReader& values, const Physics& physics,
                         Condition& condition);

/// Reports what an entry of `conditions` says that `physics: {type: interpolation}` has no meaning
/// for; on the boundary or inside the domain.
void check_interpolated(const DocumentNode& node, ValueReader& values);

}  // namespace rfm
