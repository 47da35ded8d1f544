#pragma once

#include <optional>
#include <string>

#include "core/region.hpp"
#include "problems/value_reader.hpp"

namespace rfm {

/// The shape with the Euclidean distance for its function where `node`, the map of a kind of shape,
/// says `exact: true`; else as it is. Values with mistakes were reported when the shape was built.
Region with_exact_distance(const Region& region, const std::string& kind, const DocumentNode& node,
                           const ValueReader& values);

/// The Euclidean distance of a shape with several sides as a whole, where `node` says `exact: true`
/// and the kind has one: `omega` of its name. (Shapes of lists of points have theirs in `Outline`.)
std::optional<Field> whole_distance(const std::string& kind, const DocumentNode& node,
                                    const ValueReader& values);

}  // namespace rfm
