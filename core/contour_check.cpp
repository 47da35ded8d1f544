#include "core/contour_check.hpp"

#include <algorithm>
#include <cmath>

#include "core/contour.hpp"
#include "core/orientation.hpp"

namespace rfm {
namespace {

double area(const Point& a, const Point& b, const Point& c) {
  return cross({b[0] - a[0], b[1] - a[1]}, {c[0] - a[0], c[1] - a[1]});
}

// On which side of a chord a point lies; on its line, where `winds_around` takes it to lie: as if
// moved a little to the right and, by still less, up.
int side_of(const Point& p, const Point& q, const Point& x) {
  const int side = orientation(p, q, x);
  if (side != 0) return side;
  if (p[1] != q[1]) return q[1] > p[1] ? -1 : 1;
  return q[0] > p[0] ? 1 : -1;
}

// Whether a point lies between a curve and its chord.
bool in_cap(const CurvePiece& piece, double radius, const Point& x) {
  const Point &p = piece.from, &q = piece.to;
  if ((side_of(p, q, x) < 0) != (piece.turn > 0)) return false;
  if (radius > 0) {  // see `disk_primitive`
    const double u = x[0] - (p[0] + q[0]) / 2, v = x[1] - (p[1] + q[1]) / 2;
    const double dx = q[0] - p[0], dy = q[1] - p[1], length = std::hypot(dx, dy);
    const double height = (dx * v - dy * u) / length;
    return (length * length / 4 - u * u - v * v) / (2 * radius) +
               piece.turn * piece.weight * height >
           0;
  }
  const double w = piece.weight;
  const Point control{piece.weighted_control[0] / w, piece.weighted_control[1] / w};
  const double whole = area(p, control, q);
  const double a = area(x, control, q) / whole, c = area(p, control, x) / whole, b = 1 - a - c;
  return b > 0 && b < 1 && 4 * w * w * a * c > b * b;
}

// Both sides of the middle of a piece.
std::array<Point, 2> beside(const CurvePiece& piece) {
  const Point m = piece.middle();
  const double dx = 1e-4 * (piece.to[0] - piece.from[0]), dy = 1e-4 * (piece.to[1] - piece.from[1]);
  return {Point{m[0] - dy, m[1] + dx}, Point{m[0] + dy, m[1] - dx}};
}

}  // namespace

ContourParity::ContourParity(const std::vector<std::vector<ContourLink>>& contours,
                             const std::vector<CurvedEdge>& edges) {
  for (const auto& contour : contours) {
    std::vector<Point>& chords = chords_.emplace_back();
    for (const ContourLink& link : contour) {
      if (link.is_tangent) continue;
      chords.push_back(link.piece.from);
      const CurvedEdge& edge = edges[link.piece.edge];
      if (!link.piece.is_straight()) curves_.push_back({link.piece, edge.center ? edge.radius : 0});
    }
  }
}

bool ContourParity::is_inside(const Point& point) const {
  bool inside = false;
  for (const std::vector<Point>& chords : chords_)
    if (winds_around(chords, point)) inside = !inside;
  for (const auto& [piece, radius] : curves_)
    if (in_cap(piece, radius, point)) inside = !inside;
  return inside;
}

std::vector<std::pair<std::size_t, std::size_t>> wrong_links(
    const RegionEvaluator& region, const std::vector<std::vector<ContourLink>>& contours,
    const std::vector<CurvedEdge>& edges) {
  const ContourParity parity(contours, edges);
  std::vector<std::pair<std::size_t, std::size_t>> wrong;
  const auto is_wrong = [&](const CurvePiece& piece) {
    return std::ranges::any_of(
        beside(piece), [&](const Point& x) { return region.contains(x) != parity.is_inside(x); });
  };
  for (std::size_t c = 0; c < contours.size(); ++c)
    for (std::size_t i = 0; i < contours[c].size(); ++i) {
      if (contours[c][i].is_tangent) continue;
      const CurvePiece& piece = contours[c][i].piece;
      const auto halves = piece.halves();
      if (is_wrong(piece) || is_wrong(halves[0].halves()[0]) || is_wrong(halves[1].halves()[1]))
        wrong.push_back({c, i});
    }
  return wrong;
}

}  // namespace rfm
