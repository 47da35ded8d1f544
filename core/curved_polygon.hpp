#pragma once

#include <vector>

#include "core/curved_contour.hpp"
#include "core/outline.hpp"

namespace rfm {

/// The inside of simple contours with curved edges, which may lie in each other (holes, islands),
/// either way round: see `polygon` for names and nesting.
///
/// The polygon of the chords is a Boolean expression with each chord once (`chain_expression`). The
/// chord h ≥ 0 of an arc is then replaced by h ∪ c where the arc bulges outward and by h ∩ ¬c where
/// it bulges inward, c being the inside of its circle or conic (theorem 6 of Shapiro 2007; Shapiro
/// & Vossler 1991): beyond the ends of the arc its chord goes on as that of a polygon does, and
/// nothing vanishes inside. Arcs are divided, with a separator for each part, until the triangles
/// that hold them do not meet other edges and each corner turns as its chords do; where two arcs
/// pass into each other with a common tangent and opposite curvature, the tangent is a further
/// separator. Separators bound nothing but single points. Where the whole region lies inside c, the
/// chord is left out.
///
/// The result is compared with the parity of the contours beside every edge (`wrong_links`): where
/// it is wrong, edges are divided once more, up to four times. What is narrower than 10⁻⁴ of a
/// piece is not seen.
///
/// Functions of arcs are those of `circle` and normalised conics; edges on one circle share it.
///
/// Throws `InvalidArgument` for bulges and weights that are not finite, weights that are not
/// positive, and edges that cross, touch, or come closer than about 10⁻³ of their length, by the
/// names of their groups or their own.
Outline curved_polygon(const std::vector<CurvedContour>& contours);

}  // namespace rfm
