#pragma once

#include <array>

#include "core/box.hpp"

namespace rfm {

/// A straight segment or an arc of a circle in the plane, with a direction: what is to its left is
/// positive. Formulas are written from the chord, so that nothing is lost where an arc is almost
/// straight.
struct CircularEdge {
  Point from{}, to{};
  /// The tangent of a quarter of the arc's angle, positive where it turns left; 0 is straight.
  double bulge = 0;

  /// The arc that leaves `from` along a direction (of unit length) and arrives at `to`.
  static CircularEdge leaving(const Point& from, const Point& direction, const Point& to);

  double chord() const;
  /// Of its circle, positive where it turns left.
  double curvature() const;
  /// Half of the arc's angle is that between its chord and its tangents; unit vectors.
  Point start_direction() const;
  Point end_direction() const;
  Point middle() const;
  /// Of an arc.
  Point center() const;
  CircularEdge reversed() const { return {to, from, -bulge}; }
  /// The parts up to and from a point of it.
  std::array<CircularEdge, 2> divided_at(const Point& point) const;

  /// Whether the nearest point of its line or circle lies on it (at the centre of a circle all
  /// points are nearest, and this is true).
  bool holds_foot(const Point& point) const;
  double distance(const Point& point) const;
  Box bounding_box() const;

  /// The distance from its line or circle, positive on the left: 2F / (1 + √(1 − 2κF)), F = κ/2
  /// (L²/4 − u² − v²) + v (1 − b²)/(1 + b²) in coordinates u along the chord from its middle and v
  /// across. For jets and numbers.
  template <class Number>
  Number signed_distance(const Number& x, const Number& y) const {
    const double length = chord(), k = curvature();
    const double c = (to[0] - from[0]) / length, s = (to[1] - from[1]) / length;
    const Number dx = x - Number((from[0] + to[0]) / 2), dy = y - Number((from[1] + to[1]) / 2);
    const Number v = Number(c) * dy - Number(s) * dx;
    if (bulge == 0) return v;
    const Number u = Number(c) * dx + Number(s) * dy;
    const double cosine = (1 - bulge * bulge) / (1 + bulge * bulge);
    const Number f =
        Number(k / 2) * (Number(length * length / 4) - u * u - v * v) + Number(cosine) * v;
    using std::sqrt;
    return Number(2.0) * f / (Number(1.0) + sqrt(Number(1.0) - Number(2 * k) * f));
  }
};

}  // namespace rfm
