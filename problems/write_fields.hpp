#pragma once

#include <string>
#include <vector>

#include "problems/field_sampling.hpp"
#include "solvers/discretized_region.hpp"

namespace rfm {

/// Writes fields over a region as a `.vtu` file for ParaView, cut to the true boundary, with about
/// `resolution` points along the longest side. A field of two or three components is a vector.
/// Throws `ComputationError` if a value is not finite or the file cannot be written.
///
///     write_vtu(domain, {{"u", {u}}, {"gradient", gradient(u, 2)}}, "ring.vtu");
void write_vtu(const DiscretizedRegion& domain, const std::vector<NamedField>& fields,
               const std::string& path, int resolution = 128);

}  // namespace rfm
