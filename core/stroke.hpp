#pragma once

#include <vector>

#include "core/circular_edge.hpp"
#include "core/curved_contour.hpp"

namespace rfm {

/// The chain of segments through the points, without those of length zero. A closed one goes on
/// from the last point to the first, which may be repeated at the end. Throws `InvalidArgument` for
/// less than two different points.
std::vector<CircularEdge> polyline_edges(const std::vector<Point>& points, bool closed);

/// The boundary of the points within width/2 of a chain of segments and arcs, each beginning where
/// the one before it ends: round at corners and at the ends of an open chain. Exact: offsets of
/// segments and arcs are segments and arcs.
///
/// Offsets of both sides, arcs about corners and semicircles about the ends are cut where they
/// cross each other; what lies nearer to the chain than width/2 is dropped, and the rest is joined
/// to contours. So a chain may cross itself, turn on a radius below width/2 or have segments
/// shorter than that. Time O(n²).
///
/// Edges belong to the groups `left` and `right` of the chain, `start` and `end`, and are named
/// left1, left2, … Throws `InvalidArgument` unless width > 0, and where the stroke touches itself.
std::vector<CurvedContour> stroke_outline(const std::vector<CircularEdge>& chain, bool closed,
                                          double width);

}  // namespace rfm
