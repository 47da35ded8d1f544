#pragma once

#include <vector>

#include "core/region.hpp"

namespace rfm {

/// What a closed region is along a surface where the primitives of these numbers vanish: there each
/// may count with either sign (those that are multiples of each other in `bounds` together), and
/// what the others say decides. So a set on the boundary belongs to the region, which R-functions
/// and bounds along the set cannot tell from rounding. Throws `InvalidArgument` for more than eight
/// surfaces that are no multiples of each other.
Region closed_along(const RegionEvaluator& region, const std::vector<int>& vanishing,
                    const Box& bounds);

}  // namespace rfm
