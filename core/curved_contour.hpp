#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/curve_piece.hpp"

namespace rfm {

/// How a corner is joined to the next one.
struct EdgeCurve {
  /// Of a circular arc: the tangent of a quarter of its angle, positive where it runs
  /// counter-clockwise (as in DXF); 0 is straight, 1 a semicircle.
  double bulge = 0;
  /// Of a conic: the point where the tangents at its ends meet, and the weight of the rational
  /// quadratic Bézier curve: an arc of an ellipse below 1, of a parabola at 1, of a hyperbola
  /// above.
  struct Conic {
    Point control{};
    double weight = 1;
  };
  std::optional<Conic> conic = {};
};

/// A closed contour of straight and curved edges: edges[i] joins points[i] and points[i + 1], and
/// is called names[i] or, without names, `prefix`edge1, `prefix`edge2, …
struct CurvedContour {
  std::vector<Point> points;
  std::vector<EdgeCurve> edges;
  std::string prefix = {};
  std::vector<std::string> names = {};
  /// Of each edge, or nothing: edges of one group are a side of this name together.
  std::vector<std::string> groups = {};

  std::string name(std::size_t edge) const;
};

/// An edge as it was given, with what names and functions need.
struct CurvedEdge {
  std::string name, group;
  CurvePiece whole;               ///< of an arc beyond a semicircle, its first half
  std::optional<Point> center{};  ///< of a circular arc
  double radius = 0;
  Point from{}, to{};
};

/// The contour as pieces, counter-clockwise, each turning by 180° at most; its edges, but those of
/// length zero, are added to `edges`, which the pieces number. A curve that is nowhere farther from
/// its chord than 10⁻⁹ of the size of the contour is its chord: the sliver between them would be
/// lost in all that follows. Throws `InvalidArgument` for numbers
/// that are not finite, weights that are not positive, less than two different points, and no area.
std::vector<CurvePiece> cleaned(const CurvedContour& contour, std::vector<CurvedEdge>& edges);

/// A polygon that follows the pieces: their ends, their middles, and corners of their hulls.
std::vector<Point> outline_of(const std::vector<CurvePiece>& pieces);

}  // namespace rfm
