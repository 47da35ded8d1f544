#pragma once

#include "core/region.hpp"
#include "problems/value_reader.hpp"

namespace rfm {

/// The shape with the Euclidean distance for its function where `node`, the map of a kind of shape,
/// says `exact: true`; else as it is. Values with mistakes were reported when the shape was built.
Region with_exact_distance(const Region& region, const std::string& kind, const DocumentNode& node,
                           const ValueReader& values);

}  // namespace rfm
