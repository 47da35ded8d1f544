#pragma once

#include "core/region.hpp"
#include "problems/output/pixel_window.hpp"

namespace rfm {

/// Samples a plane region at the centres of pixels. A tree of tiles is descended with bounds of the
/// primitives, so that only pixels next to the boundary are looked at one by one; there each
/// primitive's distance is |level| / |∇level|, and the Boolean expression takes minima and maxima
/// of them, so that corners are sharp. Seams where parts of a union touch along a curve are no
/// boundary. In parallel; the cost grows with the number of pixels on the boundary, not with that
/// of primitives.
///
/// Distances are infinite beyond `reach` pixels. A primitive that is not defined at a pixel counts
/// as not containing it.
RegionPixels sample_region(const RegionEvaluator& region, const PixelWindow& window,
                           double reach = 4);

}  // namespace rfm
