#pragma once

#include "problems/boundary_reader.hpp"
#include "problems/problem.hpp"
#include "problems/shape_reader.hpp"
#include "problems/value_reader.hpp"

namespace rfm {

/// Reads `study`. Parameters must be known.
Study read_study(const DocumentNode& root, ValueReader& values);
/// Reads `discretization`.
Discretization read_discretization(const DocumentNode& root, ValueReader& values,
                                   const std::vector<std::string>& unknowns);
/// Reads `probes`; their formulas may name results.
void read_probes(const DocumentNode& root, ValueReader& values, ShapeReader& shapes,
                 BoundaryReader& boundary, Problem& problem);
/// Reads `verify`. Quantities that name probes are checked against those of `problem`.
void read_verification(const DocumentNode& root, ValueReader& values, Problem& problem);
/// Reads `outputs`.
void read_outputs(const DocumentNode& root, ValueReader& values, Problem& problem);

}  // namespace rfm
