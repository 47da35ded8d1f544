#include "core/edge_intersections.hpp"

#include <cmath>

namespace rfm {
namespace {

double dot(const Point& a, const Point& b) { return a[0] * b[0] + a[1] * b[1]; }
double cross(const Point& a, const Point& b) { return a[0] * b[1] - a[1] * b[0]; }
Point minus(const Point& a, const Point& b) { return {a[0] - b[0], a[1] - b[1]}; }
Point along(const Point& from, const Point& direction, double t) {
  return {from[0] + t * direction[0], from[1] + t * direction[1]};
}

// A circle so large that its arc is its chord for a first guess.
bool is_flat(const CircularEdge& edge) { return std::fabs(edge.bulge) < 1e-7; }

Point chord_direction(const CircularEdge& edge) {
  const double length = edge.chord();
  return {(edge.to[0] - edge.from[0]) / length, (edge.to[1] - edge.from[1]) / length};
}

// The gradient of the distance, to the left.
Point left_normal(const CircularEdge& edge, const Point& at) {
  if (edge.bulge == 0) {
    const Point d = chord_direction(edge);
    return {-d[1], d[0]};
  }
  const Point center = edge.center(), out = minus(at, center);
  const double sign = (edge.bulge > 0 ? -1 : 1) / std::hypot(out[0], out[1]);
  return {sign * out[0], sign * out[1]};
}

std::vector<Point> guesses(const CircularEdge& a, const CircularEdge& b) {
  if (is_flat(a) && is_flat(b)) {
    const Point u = chord_direction(a), v = chord_direction(b);
    const double sine = cross(u, v);
    if (std::fabs(sine) < 1e-12) return {};
    return {along(a.from, u, cross(minus(b.from, a.from), v) / sine)};
  }
  if (is_flat(b)) return guesses(b, a);
  const Point c = b.center();
  const double radius = 1 / std::fabs(b.curvature());
  Point foot, direction;
  double half_square;
  if (is_flat(a)) {
    direction = chord_direction(a);
    foot = along(a.from, direction, dot(minus(c, a.from), direction));
    half_square = radius * radius - dot(minus(foot, c), minus(foot, c));
  } else {  // the radical line
    const Point d = minus(a.center(), c);
    const double distance = std::hypot(d[0], d[1]), other = 1 / std::fabs(a.curvature());
    if (distance <= 1e-12 * (radius + other)) return {};
    const double reach = (distance + (radius - other) * (radius + other) / distance) / 2;
    foot = along(c, d, reach / distance);
    direction = {-d[1] / distance, d[0] / distance};
    half_square = (radius - reach) * (radius + reach);
  }
  if (!(half_square > 0)) return {};
  const double half = std::sqrt(half_square);
  return {along(foot, direction, -half), along(foot, direction, half)};
}

}  // namespace

std::vector<Point> crossings(const CircularEdge& a, const CircularEdge& b) {
  std::vector<Point> points = guesses(a, b);
  for (Point& x : points)
    for (int step = 0; step < 3; ++step) {
      const double f = a.signed_distance(x[0], x[1]), g = b.signed_distance(x[0], x[1]);
      const Point m = left_normal(a, x), n = left_normal(b, x);
      const double sine = cross(m, n);
      if (std::fabs(sine) < 1e-9) break;
      x = {x[0] - (f * n[1] - g * m[1]) / sine, x[1] - (g * m[0] - f * n[0]) / sine};
    }
  return points;
}

}  // namespace rfm
