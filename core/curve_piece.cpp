#include "core/curve_piece.hpp"

#include <algorithm>
#include <cmath>

namespace rfm {
namespace {

Point combination(double a, const Point& p, double b, const Point& q) {
  return {a * p[0] + b * q[0], a * p[1] + b * q[1]};
}

Point unit(const Point& v) {
  const double length = std::hypot(v[0], v[1]);
  return {v[0] / length, v[1] / length};
}

double dot(const Point& a, const Point& b) { return a[0] * b[0] + a[1] * b[1]; }

void find_turn(CurvePiece& piece) {
  const double sine = cross(piece.chord(), piece.start_direction());
  piece.turn = sine < 0 ? 1 : sine > 0 ? -1 : 0;
}

// Whether `x` lies between `u` and `v`, or along one of them.
bool in_cone(const Point& x, const Point& u, const Point& v) {
  constexpr double rounding = 1e-12;
  const double opening = cross(u, v);
  if (dot(x, u) + dot(x, v) <= 0) return false;
  if (std::fabs(opening) < rounding) return std::fabs(cross(u, x)) < rounding;
  return cross(u, x) * opening >= -rounding && cross(x, v) * opening >= -rounding;
}

}  // namespace

CurvePiece CurvePiece::straight(const Point& from, const Point& to, int edge) {
  return {from, to, combination(0.5, from, 0.5, to), 1, edge, 0};
}

CurvePiece CurvePiece::arc(const Point& from, const Point& to, double bulge, int edge) {
  // Half of the angle at the centre, of the sign of the bulge: its cosine is the weight.
  const double square = bulge * bulge, cosine = (1 - square) / (1 + square),
               sine = 2 * bulge / (1 + square);
  const Point half{(to[0] - from[0]) / 2, (to[1] - from[1]) / 2};
  const Point middle = combination(0.5, from, 0.5, to);
  return {from,   to,   {cosine * middle[0] + sine * half[1], cosine * middle[1] - sine * half[0]},
          cosine, edge, bulge > 0 ? 1 : bulge < 0 ? -1 : 0};
}

CurvePiece CurvePiece::conic(const Point& from, const Point& control, double weight,
                             const Point& to, int edge) {
  CurvePiece piece{from, to, {weight * control[0], weight * control[1]}, weight, edge, 0};
  find_turn(piece);
  return piece;
}

Point CurvePiece::middle() const {
  const double sum = 2 + 2 * weight;
  return {(from[0] + 2 * weighted_control[0] + to[0]) / sum,
          (from[1] + 2 * weighted_control[1] + to[1]) / sum};
}

std::array<CurvePiece, 2> CurvePiece::halves() const {
  const Point m = middle();
  if (is_straight()) return {straight(from, m, edge), straight(m, to, edge)};
  const double half_weight = std::sqrt((1 + weight) / 2);
  const auto corners = hull();
  return {conic(from, corners[1], half_weight, m, edge),
          conic(m, corners[2], half_weight, to, edge)};
}

CurvePiece CurvePiece::reversed() const {
  return {to, from, weighted_control, weight, edge, -turn};
}

Point CurvePiece::chord() const { return unit({to[0] - from[0], to[1] - from[1]}); }

Point CurvePiece::start_direction() const {
  return unit(combination(1, weighted_control, -weight, from));
}

Point CurvePiece::end_direction() const {
  return unit(combination(weight, to, -1, weighted_control));
}

std::array<Point, 4> CurvePiece::hull() const {
  const double a = 1 / (1 + weight);
  return {from, combination(a, from, a, weighted_control), combination(a, to, a, weighted_control),
          to};
}

bool hulls_meet(const std::array<Point, 4>& a, const std::array<Point, 4>& b) {
  // A line that separates them runs along a side of one of them.
  for (const auto& [one, other] : {std::pair(&a, &b), std::pair(&b, &a)})
    for (int i = 0; i < 4; ++i) {
      const Point &p = (*one)[i], &q = (*one)[(i + 1) % 4];
      const Point along{q[0] - p[0], q[1] - p[1]};
      const double length = std::hypot(along[0], along[1]);
      if (length == 0) continue;
      for (const Point& normal : {Point{-along[1], along[0]}, along}) {
        double low[2] = {INFINITY, INFINITY}, high[2] = {-INFINITY, -INFINITY}, size = 0;
        int k = 0;
        for (const auto* corners : {&a, &b}) {
          for (const Point& corner : *corners) {
            const double height = dot({corner[0] - p[0], corner[1] - p[1]}, normal) / length;
            low[k] = std::min(low[k], height);
            high[k] = std::max(high[k], height);
            size = std::max(size, std::fabs(height));
          }
          ++k;
        }
        if (std::max(low[0], low[1]) > std::min(high[0], high[1]) + 1e-13 * size) return false;
      }
    }
  return true;
}

bool cones_meet(const CurvePiece& first, const CurvePiece& second) {
  const auto back = [](const Point& direction) { return Point{-direction[0], -direction[1]}; };
  const Point u = back(first.chord()), v = back(first.end_direction());
  const Point p = second.chord(), q = second.start_direction();
  return in_cone(p, u, v) || in_cone(q, u, v) || in_cone(u, p, q) || in_cone(v, p, q);
}

}  // namespace rfm
