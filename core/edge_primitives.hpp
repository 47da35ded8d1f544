#pragma once

#include "core/curved_contour.hpp"
#include "core/region.hpp"

namespace rfm {

// Primitives of curved edges, without names.

/// The disk of a circular arc: (r² − |x − c|²) / 2r as a polynomial about the middle of the chord,
/// so that nothing is lost where the centre is far away: κ/2 (L²/4 − |x − m|²) + v (1 − b²)/(1 +
/// b²), v the height over the chord, for the bulge b (of half of an arc beyond a semicircle).
Primitive disk_primitive(const CurvedEdge& edge);
/// 4 w² a c − b² in barycentric coordinates, normalised by eq. (4.9): zero on the conic, positive
/// on the side of its chord.
Primitive conic_primitive(const CurvePiece& piece);
/// Of the two branches of a hyperbola this one; it selects only.
Primitive branch_primitive(const CurvePiece& piece);
/// Positive on the edge among the points of its line, circle or conic.
Field part_of_curve(const CurvedEdge& edge);

}  // namespace rfm
