#pragma once

#include <string>
#include <vector>

#include "core/curve_piece.hpp"

namespace rfm {

/// A piece of a contour, or a tangent of it.
struct ContourLink {
  CurvePiece piece;
  /// Not a part of the contour but its tangent in the point where `piece` begins; how far it goes
  /// on there tells the direction only.
  bool is_tangent = false;
  /// Which way the lines of chords and tangents turn where it begins: 1 left, −1 right, 0 unless a
  /// curve or a tangent takes part.
  int turn = 0;
};

/// Closed counter-clockwise contours of curve pieces, divided until the chords tell how they lie:
/// hulls of pieces meet only where pieces follow each other; at each corner the chords turn as the
/// curves do, and neither curve crosses the chord of the other extended. Where that takes more than
/// chords (arcs of opposite curvature with a common tangent, corners that turn by a little against
/// the curvature of an arc), tangents become links of their own. `names` are those of the edges.
/// Throws `InvalidArgument` for edges that division does not part.
std::vector<std::vector<ContourLink>> divided(std::vector<std::vector<CurvePiece>> contours,
                                              const std::vector<std::string>& names);

}  // namespace rfm
