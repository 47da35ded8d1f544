#pragma once

#include <string>
#include <vector>

#include "core/curve_piece.hpp"

namespace rfm {

/// A piece of a contour, and where it begins as an edge of the polygon of chords.
struct ContourLink {
  CurvePiece piece;
  Point start{};
  /// Not a part of the contour but its tangent at a point of inflection.
  bool is_tangent = false;
};

/// Closed counter-clockwise contours of curve pieces, divided until the chords tell how they lie:
/// hulls of pieces meet only where pieces follow each other; at each corner the chords turn as the
/// curves do, and neither curve crosses the chord of the other extended. Where two arcs of opposite
/// curvature have a common tangent, it becomes a link of its own. `names` are those of the edges.
/// Throws `InvalidArgument` for edges that division does not part.
std::vector<std::vector<ContourLink>> divided(std::vector<std::vector<CurvePiece>> contours,
                                              const std::vector<std::string>& names);

}  // namespace rfm
