#pragma once

#include "problems/value_reader.hpp"

namespace rfm {

/// Reads `discretization.basis.knots` into `result`, whose box and extension are known by then.
void read_knots(const DocumentNode& basis, ValueReader& values, Discretization& result);

}  // namespace rfm
