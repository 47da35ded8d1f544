#include "core/winding_sign.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "core/error.hpp"
#include "core/piece_loops.hpp"
#include "core/point_algebra.hpp"

namespace rfm {
namespace {

constexpr double pi = std::numbers::pi;

double cross_z(const Point& a, const Point& b) { return a[0] * b[1] - a[1] * b[0]; }

bool same(const Point& a, const Point& b, double tolerance) {
  return norm(difference(a, b)) <= tolerance;
}

// The circle of an arc from a to b.
struct Circle {
  Point center{};
  double radius = 0;
};
Circle circle_of(const Point& a, const Point& b, double bulge) {
  const Point chord = difference(b, a);
  // The centre lies at half the chord times (1 − bulge²)/(2 bulge) to the left of its middle.
  const double shift = (1 - bulge * bulge) / (4 * bulge);
  return {{0.5 * (a[0] + b[0]) - shift * chord[1], 0.5 * (a[1] + b[1]) + shift * chord[0]},
          norm(chord) * (1 + bulge * bulge) / (4 * std::fabs(bulge))};
}

// The angle that a piece from a to b turns about a point.
double turn(const Point& a, const Point& b, double bulge, const Point& at) {
  const Point u = difference(a, at), v = difference(b, at);
  const double chord = std::atan2(cross_z(u, v), dot(u, v));
  if (bulge == 0) return chord;
  // An arc passes on the right of its chord where it turns left. A point between them is passed on
  // the other side.
  const Circle circle = circle_of(a, b, bulge);
  const bool within = norm(difference(at, circle.center)) < circle.radius;
  // By the very number that jumps there: on the chord another one may be rounded to the other side.
  const bool right_of_chord = chord < 0;
  if (bulge > 0) return within && right_of_chord ? chord + 2 * pi : chord;
  return within && !right_of_chord ? chord - 2 * pi : chord;
}

// The solid angle of a triangle (A. van Oosterom and J. Strackee, 1983).
double solid_angle(const std::array<Point, 3>& corners, const Point& at) {
  const Point a = difference(corners[0], at), b = difference(corners[1], at),
              c = difference(corners[2], at);
  const Point bc{b[1] * c[2] - b[2] * c[1], b[2] * c[0] - b[0] * c[2], b[0] * c[1] - b[1] * c[0]};
  const double la = norm(a), lb = norm(b), lc = norm(c);
  return 2 *
         std::atan2(dot(a, bc), la * lb * lc + dot(a, b) * lc + dot(b, c) * la + dot(c, a) * lb);
}

}  // namespace

WindingSign::WindingSign(const std::vector<ThinSet>& pieces)
    : dimension_(pieces.empty() ? 2 : pieces[0].dimension) {
  if (dimension_ == 2) {
    for (const auto& loop : closed_loops(pieces))
      for (const LoopPiece& piece : loop) pieces_.push_back({{piece.from, piece.to}, piece.bulge});
    return;
  }
  Point low, high;
  low.fill(std::numeric_limits<double>::infinity());
  high.fill(-std::numeric_limits<double>::infinity());
  for (const ThinSet& set : pieces) {
    if (set.dimension != dimension_ || set.points.size() != 3)
      throw InvalidArgument("closed boundaries are made of segments and arcs, or of triangles");
    Piece piece;
    std::copy(set.points.begin(), set.points.end(), piece.corners.begin());
    pieces_.push_back(piece);
    for (const Point& point : set.points)
      for (int axis = 0; axis < 3; ++axis) {
        low[axis] = std::min(low[axis], point[axis]);
        high[axis] = std::max(high[axis], point[axis]);
      }
  }
  check_edges(1e-9 * norm(difference(high, low)));
}

void WindingSign::check_edges(double tolerance) const {
  for (const Piece& piece : pieces_)
    for (int i = 0; i < 3; ++i) {
      const Point &from = piece.corners[i], &to = piece.corners[(i + 1) % 3];
      int same_way = 0, other_way = 0;
      for (const Piece& other : pieces_)
        for (int k = 0; k < 3; ++k) {
          const Point &a = other.corners[k], &b = other.corners[(k + 1) % 3];
          same_way += same(a, from, tolerance) && same(b, to, tolerance);
          other_way += same(a, to, tolerance) && same(b, from, tolerance);
        }
      if (same_way != other_way)
        throw InvalidArgument("the triangles do not close, or are not turned the same way");
    }
}

bool WindingSign::is_inside(const Point& point) const {
  double angle = 0;
  for (const Piece& piece : pieces_)
    angle += dimension_ == 2 ? turn(piece.corners[0], piece.corners[1], piece.bulge, point)
                             : solid_angle(piece.corners, point);
  const double whole = dimension_ == 2 ? 2 * pi : 4 * pi;
  return std::lround(angle / whole) % 2 != 0;
}

void WindingSign::evaluate(const std::array<const double*, 3>& coordinates, int count,
                           int variables, int order, double* jets, int stride) const {
  for (int c = 0; c < jet_size(variables, order); ++c)
    std::fill_n(jets + std::ptrdiff_t(c) * stride, count, 0.0);
  for (int i = 0; i < count; ++i) {
    Point point{};
    for (int axis = 0; axis < dimension_; ++axis) point[axis] = coordinates[axis][i];
    jets[i] = is_inside(point) ? 1 : -1;
  }
}

// The distance from a piece, or less.
double WindingSign::distance_below(const Piece& piece, const Point& point) const {
  if (dimension_ == 2 && piece.bulge != 0) {
    const Circle circle = circle_of(piece.corners[0], piece.corners[1], piece.bulge);
    return std::fabs(norm(difference(point, circle.center)) - circle.radius);
  }
  // From the ball about the corners' middle.
  Point middle{};
  const int count = dimension_ == 2 ? 2 : 3;
  for (int i = 0; i < count; ++i)
    for (int axis = 0; axis < 3; ++axis) middle[axis] += piece.corners[i][axis] / count;
  double radius = 0;
  for (int i = 0; i < count; ++i)
    radius = std::max(radius, norm(difference(piece.corners[i], middle)));
  if (dimension_ == 3) return norm(difference(point, middle)) - radius;
  const Point along = difference(piece.corners[1], piece.corners[0]);
  const double t =
      std::clamp(dot(difference(point, piece.corners[0]), along) / dot(along, along), 0.0, 1.0);
  return norm({point[0] - piece.corners[0][0] - t * along[0],
               point[1] - piece.corners[0][1] - t * along[1]});
}

FunctionBounds WindingSign::bounds(const Box& box) const {
  const Point center = box.center();
  const double radius = norm(difference(box.high, center)) * (1 + 1e-12);
  FunctionBounds bounds;
  bounds.value = Interval(-1, 1);
  bounds.smooth = false;
  if (!std::isfinite(radius)) return bounds;
  for (const Piece& piece : pieces_)
    if (!(distance_below(piece, center) * (1 - 1e-12) > radius)) return bounds;
  bounds.value = is_inside(center) ? 1 : -1;
  bounds.smooth = true;
  return bounds;
}

std::vector<double> WindingSign::breakpoints(int) const { return {}; }

Box WindingSign::valid() const {
  constexpr double infinite = std::numeric_limits<double>::infinity();
  return {dimension_, {-infinite, -infinite, -infinite}, {infinite, infinite, infinite}};
}

Field signed_function(const std::vector<ThinSet>& pieces, int p) {
  return field(std::make_shared<const WindingSign>(pieces)) * joined(pieces, p);
}

}  // namespace rfm
