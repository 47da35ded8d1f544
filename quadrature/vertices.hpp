#pragma once

#include <vector>

#include "core/region.hpp"

namespace rfm {

/// A corner of a plane region, or a vertex of a body.
struct Vertex {
  Point point{};
  /// The primitives that meet, ascending: two or more in the plane, three or more in space.
  std::vector<int> primitives;
  /// Interior angle in radians, 0 to 2π; in space the solid angle, 0 to 4π.
  double angle = 0;
  /// Pieces of the boundary (in space: edges) that leave the point; two at a corner, four where two
  /// corners touch, three or more at a vertex.
  int edges = 0;
};

struct VertexSearch {
  /// Sorted by coordinates.
  std::vector<Vertex> vertices;
  /// Where primitives touch without crossing, or are singular (the apex of a cone), and where
  /// curves cross in which two surfaces of space meet: the middles of what the search could not
  /// resolve. There may be a vertex nearby, or none. Contacts along whole curves are none of these,
  /// nor are curves that three surfaces have in common.
  std::vector<Point> unresolved;
  /// Parts of the region's box that were left out, as too many primitives meet in them.
  int crowded_boxes = 0;
};

/// All corners of a region in the plane, all vertices of one in space, within `box` (that of the
/// region). Common zeros of two (three) primitives are isolated with proof (see `isolate_zeros`),
/// so none is missed outside `unresolved`; a zero counts if the boundary to first order has a
/// corner there. Points are right to rounding times the inverse sine of the angle. Primitives with
/// the same zero set count as one. Corners of a single primitive (a corner of |x| + |y| = 1, an
/// apex) are not listed. A region of the line has none.
VertexSearch find_vertices(const RegionEvaluator& region, const Box& box);

}  // namespace rfm
