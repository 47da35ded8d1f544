#pragma once

#include <optional>

#include "core/region.hpp"

namespace rfm {

/// How far the points of a region within `box` reach along ±x_axis: a rigorous bound of the largest
/// (`upper`) or smallest coordinate among them, no farther than the box itself; empty where the box
/// is proved to hold no point of the region.
///
/// Each primitive is bounded by its mean value form; where two of them decide, also the positive
/// combination of both whose gradient is along the axis. The bound is thus of second order in the
/// size of the box, at smooth extremes as well as at edges and at corners of the plane; at corners
/// in space it is of first order.
std::optional<double> reach(const RegionEvaluator& region, const Box& box, int axis, bool upper);

}  // namespace rfm
