#pragma once

#include "core/box.hpp"
#include "core/region.hpp"

namespace rfm {

/// The smallest box that holds the region, found by branch and bound on the bounds of its
/// primitives (`reach`): rigorous from outside, and within 10⁻¹² of its size from inside where the
/// extreme is smooth or lies on an edge. Where a flat face, a straight edge or a corner of two
/// primitives (of three in space) is extreme, its coordinate is exact to rounding, so that grid
/// lines fall on such faces exactly; at other corners (of one primitive that is not smooth) it is
/// within 10⁻⁶.
///
/// What shapes know of their own box (`Region::enclosure`) is used. Where the search ends before it
/// converged (5,000 boxes per side), the side is still from outside: `bounding_box_and_excess` says
/// by how much it may lie beyond.
///
/// Throws `InvalidArgument` if the region is empty, or not bounded within ±10¹⁵ (the message names
/// the direction).
Box bounding_box(const RegionEvaluator& region);

struct BoundingBox {
  Box box;
  /// How far the sides that did not converge lie beyond the points of the region that were found,
  /// at most; 0 where all converged.
  double excess = 0;
};
BoundingBox bounding_box_and_excess(const RegionEvaluator& region);

}  // namespace rfm
