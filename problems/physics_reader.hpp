#pragma once

#include "problems/problem.hpp"
#include "problems/shape_reader.hpp"
#include "problems/value_reader.hpp"

namespace rfm {

/// Reads `physics` with its materials.
void read_physics(const DocumentNode& root, ValueReader& values, ShapeReader& shapes,
                  Problem& problem);

}  // namespace rfm
