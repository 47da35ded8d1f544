#pragma once

#include <array>

#include "core/box.hpp"

namespace rfm {

/// A straight edge or an arc of a conic without inflection as a rational quadratic Bézier curve in
/// homogeneous form: (1 − t)² P₀ + 2t(1 − t) wP₁ + t² P₂ over (1 − t)² + 2t(1 − t) w + t². A
/// semicircle has w = 0 and a finite wP₁. w ≥ 0: it turns by at most 180°.
struct CurvePiece {
  Point from{}, to{};
  Point weighted_control{};  ///< wP₁
  double weight = 1;
  /// The edge of which it is a part.
  int edge = 0;
  /// Which way it turns: 1 left, −1 right, 0 straight.
  int turn = 0;

  static CurvePiece straight(const Point& from, const Point& to, int edge);
  /// Bulge: the tangent of a quarter of the angle of the arc, positive if it turns left; |bulge|
  /// ≤ 1.
  static CurvePiece arc(const Point& from, const Point& to, double bulge, int edge);
  static CurvePiece conic(const Point& from, const Point& control, double weight, const Point& to,
                          int edge);

  bool is_straight() const { return turn == 0; }
  Point middle() const;
  std::array<CurvePiece, 2> halves() const;
  CurvePiece reversed() const;
  /// Directions, of unit length: of the chord, and along the curve at both ends.
  Point chord() const;
  Point start_direction() const;
  Point end_direction() const;
  /// A convex quadrilateral that holds it; its first and last corners are the ends.
  std::array<Point, 4> hull() const;
};

/// Cross product of directions of the plane.
inline double cross(const Point& a, const Point& b) { return a[0] * b[1] - a[1] * b[0]; }

/// Whether two convex quadrilaterals (or segments, with corners repeated) have a point in common,
/// up to rounding.
bool hulls_meet(const std::array<Point, 4>& a, const std::array<Point, 4>& b);

/// Whether the cones in which `first` arrives and `second` leaves their common point have a
/// direction in common.
bool cones_meet(const CurvePiece& first, const CurvePiece& second);

}  // namespace rfm
