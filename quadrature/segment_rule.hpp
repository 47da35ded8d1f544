#pragma once

#include "core/region.hpp"
#include "quadrature/quadrature_points.hpp"

namespace rfm {

/// A rule for ∫ f ds over the part of the segment from `from` to `to` that lies in a region: where
/// the segment enters and leaves is isolated by bounds along it, up to rounding, and each part is
/// divided into pieces no longer than `spacing` with `points` Gauss points each. What lies on the
/// boundary (to 1e-9) is inside. Exact to degree 2·points − 1. Throws unless spacing > 0.
VolumePoints make_segment_rule(const RegionEvaluator& region, const Point& from, const Point& to,
                               double spacing, int points);

}  // namespace rfm
