#include "core/circular_edge.hpp"

#include <algorithm>
#include <cmath>

namespace rfm {
namespace {

double dot(const Point& a, const Point& b) { return a[0] * b[0] + a[1] * b[1]; }
Point minus(const Point& a, const Point& b) { return {a[0] - b[0], a[1] - b[1]}; }

}  // namespace

CircularEdge CircularEdge::leaving(const Point& from, const Point& direction, const Point& to) {
  const Point chord = minus(to, from);
  const double along = dot(chord, direction),
               across = direction[0] * chord[1] - direction[1] * chord[0];
  // The chord is turned from the tangent by half of the arc's angle: tan of the half of that.
  return {from, to, across / (std::hypot(chord[0], chord[1]) + along)};
}

double CircularEdge::chord() const { return std::hypot(to[0] - from[0], to[1] - from[1]); }

double CircularEdge::curvature() const { return 4 * bulge / (chord() * (1 + bulge * bulge)); }

Point CircularEdge::start_direction() const {
  const double length = chord(), square = bulge * bulge;
  const double c = (1 - square) / (1 + square) / length, s = 2 * bulge / (1 + square) / length;
  const Point d = minus(to, from);
  return {c * d[0] + s * d[1], c * d[1] - s * d[0]};
}

Point CircularEdge::end_direction() const {
  const Point back = reversed().start_direction();
  return {-back[0], -back[1]};
}

Point CircularEdge::middle() const {
  return {(from[0] + to[0]) / 2 + bulge / 2 * (to[1] - from[1]),
          (from[1] + to[1]) / 2 - bulge / 2 * (to[0] - from[0])};
}

Point CircularEdge::center() const {
  const double shift = (1 - bulge * bulge) / (4 * bulge);
  return {(from[0] + to[0]) / 2 - shift * (to[1] - from[1]),
          (from[1] + to[1]) / 2 + shift * (to[0] - from[0])};
}

std::array<CircularEdge, 2> CircularEdge::divided_at(const Point& point) const {
  if (bulge == 0) return {CircularEdge{from, point, 0}, CircularEdge{point, to, 0}};
  return {leaving(from, start_direction(), point),
          leaving(to, reversed().start_direction(), point).reversed()};
}

bool CircularEdge::holds_foot(const Point& point) const {
  const bool after_start = dot(minus(point, from), start_direction()) >= 0;
  const bool before_end = dot(minus(point, to), end_direction()) <= 0;
  return std::fabs(bulge) <= 1 ? after_start && before_end : after_start || before_end;
}

double CircularEdge::distance(const Point& point) const {
  if (holds_foot(point)) return std::fabs(signed_distance(point[0], point[1]));
  return std::min(std::hypot(point[0] - from[0], point[1] - from[1]),
                  std::hypot(point[0] - to[0], point[1] - to[1]));
}

Box CircularEdge::bounding_box() const {
  Box box{2,
          {std::min(from[0], to[0]), std::min(from[1], to[1])},
          {std::max(from[0], to[0]), std::max(from[1], to[1])}};
  if (bulge == 0) return box;
  const Point middle = center();
  const double radius = 1 / std::fabs(curvature());
  for (int axis = 0; axis < 2; ++axis)
    for (const double sign : {-1.0, 1.0}) {
      Point extreme = middle;
      extreme[axis] += sign * radius;
      if (!holds_foot(extreme)) continue;
      box.low[axis] = std::min(box.low[axis], extreme[axis]);
      box.high[axis] = std::max(box.high[axis], extreme[axis]);
    }
  return box;
}

}  // namespace rfm
