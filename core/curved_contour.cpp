#include "core/curved_contour.hpp"

#include <algorithm>
#include <cmath>

#include "core/contour.hpp"
#include "core/error.hpp"
#include "core/orientation.hpp"

namespace rfm {
namespace {

// Curves that are nowhere farther than `flat` from their chords are straight.
std::vector<CurvePiece> pieces_of(const Point& from, const Point& to, const EdgeCurve& curve,
                                  int number, double flat, CurvedEdge& edge) {
  edge.from = from;
  edge.to = to;
  edge.whole = CurvePiece::straight(from, to, number);
  if (curve.conic) {
    const CurvePiece piece =
        CurvePiece::conic(from, curve.conic->control, curve.conic->weight, to, number);
    const Point top = piece.middle();
    const double height = cross(piece.chord(), {top[0] - from[0], top[1] - from[1]});
    if (std::fabs(height) > flat) edge.whole = piece;
    return {edge.whole};
  }
  const double b = curve.bulge;
  if (std::fabs(b) * std::hypot(to[0] - from[0], to[1] - from[1]) / 2 <= flat) return {edge.whole};
  // The centre lies at (1 − b²) / 4b chords to the left of the chord's middle.
  const double shift = (1 - b * b) / (4 * b), dx = to[0] - from[0], dy = to[1] - from[1];
  edge.center = Point{(from[0] + to[0]) / 2 - shift * dy, (from[1] + to[1]) / 2 + shift * dx};
  edge.radius = std::hypot(dx, dy) * (1 + b * b) / (4 * std::fabs(b));
  if (std::fabs(b) <= 1) return {edge.whole = CurvePiece::arc(from, to, b, number)};
  const Point middle{(from[0] + to[0]) / 2 + b / 2 * dy, (from[1] + to[1]) / 2 - b / 2 * dx};
  const double half = std::tan(std::atan(b) / 2);
  edge.whole = CurvePiece::arc(from, middle, half, number);
  return {edge.whole, CurvePiece::arc(middle, to, half, number)};
}

double size_of(const std::vector<Point>& points) {
  double size = 0;
  for (const Point& point : points)
    for (int axis = 0; axis < 2; ++axis)
      size = std::max(size, std::fabs(point[axis] - points[0][axis]));
  return size;
}

}  // namespace

std::string CurvedContour::name(std::size_t edge) const {
  return prefix + (edge < names.size() ? names[edge] : "edge" + std::to_string(edge + 1));
}

std::vector<Point> outline_of(const std::vector<CurvePiece>& pieces) {
  std::vector<Point> points;
  for (const CurvePiece& piece : pieces) {
    const auto corners = piece.hull();
    points.push_back(piece.from);
    if (!piece.is_straight()) points.insert(points.end(), {corners[1], piece.middle(), corners[2]});
  }
  return points;
}

std::vector<CurvePiece> cleaned(const CurvedContour& contour, std::vector<CurvedEdge>& edges) {
  std::vector<CurvePiece> pieces;
  const std::size_t count = contour.points.size();
  const double flat = 1e-9 * size_of(contour.points);
  for (std::size_t i = 0; i < count; ++i) {
    const Point &from = contour.points[i], &to = contour.points[(i + 1) % count];
    const EdgeCurve curve = i < contour.edges.size() ? contour.edges[i] : EdgeCurve{};
    const std::string name = contour.name(i);
    if (!std::isfinite(from[0]) || !std::isfinite(from[1]) || !std::isfinite(curve.bulge))
      throw InvalidArgument("the numbers of " + name + " are not finite");
    if (curve.conic && !(curve.conic->weight > 0 && curve.conic->weight < 1e6))
      throw InvalidArgument("the weight of " + name + " must be positive");
    if (from == to) continue;
    edges.push_back({name, i < contour.groups.size() ? contour.groups[i] : "", {}});
    const auto more =
        pieces_of(from, to, curve, static_cast<int>(edges.size()) - 1, flat, edges.back());
    pieces.insert(pieces.end(), more.begin(), more.end());
  }
  if (pieces.size() < 2)
    throw InvalidArgument("a curved polygon needs at least two different points");
  const std::vector<Point> outline = outline_of(pieces);
  const auto on_a_line = [&](const Point& p) {
    return orientation(outline[0], outline[1], p) == 0;
  };
  const double area = twice_area(outline);
  // As of a plain polygon, what has no area and is no line crosses itself, which is found later.
  if (area == 0 && std::ranges::all_of(outline, on_a_line))
    throw InvalidArgument("the curved polygon has no area");
  if (area < 0) {
    std::ranges::reverse(pieces);
    for (CurvePiece& piece : pieces) piece = piece.reversed();
  }
  return pieces;
}

}  // namespace rfm
