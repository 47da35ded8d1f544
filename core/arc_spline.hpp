#pragma once

#include <vector>

#include "core/circular_edge.hpp"

namespace rfm {

struct ArcSpline {
  std::vector<CircularEdge> edges;
  /// For each edge the number, from 0, of the point at which its span begins.
  std::vector<int> spans;
};

/// A smooth curve through the points in order, made of circular arcs that pass into each other with
/// a common tangent: an arc spline (D. S. Meek and D. J. Walton, "Approximating smooth planar
/// curves by arc splines", J. Comput. Appl. Math. 59 (1995) 221–231). The tangent at a point is
/// that of the circle through it and its neighbours; between two points lie two arcs of equal
/// tangent lengths (a biarc), or one where that suffices. Points on a circle or a line give that
/// circle or line. Between points of a smooth curve a distance h apart the error is O(h³).
///
/// Points of a line that were written with a limited number of digits are not on a line, and arcs
/// through them would wind about it. So what differs from its chord by less than δ, which is 1.5
/// units of the last place given (`coordinate_rounding`) and at most 10⁻⁴ of the size of the whole,
/// and by less than 1/1000 of its length, is its chord; and of chords that follow each other within
/// δ of one line, the points between are moved onto it. The curve is off by 2δ at most, and its
/// direction by 1/100. Points that need all digits of a double are not affected.
///
/// Arcs instead of polynomials: their functions are exact and normalised, their offsets are arcs
/// again, and the distance from them is a closed form.
///
/// A closed spline goes on from the last point to the first, which may be repeated at the end; an
/// open one begins and ends like the circle through the three outermost points. Points that repeat
/// the one before are passed over. Throws `InvalidArgument` for less than two different points
/// (three if closed), and where the points turn back on themselves.
ArcSpline arc_spline(const std::vector<Point>& points, bool closed);

}  // namespace rfm
