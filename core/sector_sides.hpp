#pragma once

#include <optional>
#include <vector>

#include "core/outline.hpp"

namespace rfm {

/// The straight side of a sector of 180 degrees (to rounding), which `from` and `to` are halves of:
/// a half-plane of the name `from_line`. Nothing for other angles, in radians.
std::optional<Region> straight_side(const Point& center, double from, double to);

/// Its halves, up to the centre; nothing for other angles, where both are primitives.
std::vector<OutlineSide> sector_sides(const Point& center, double from, double to);

}  // namespace rfm
