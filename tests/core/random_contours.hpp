#pragma once

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <vector>

#include "core/contour.hpp"
#include "core/curved_contour.hpp"
#include "tests/core/random_polygons.hpp"

namespace rfm {

using Real = long double;

inline Real from_segment(const Point& p, const Point& q, const Point& x) {
  const Real dx = Real(q[0]) - p[0], dy = Real(q[1]) - p[1];
  Real t = ((x[0] - Real(p[0])) * dx + (x[1] - Real(p[1])) * dy) / (dx * dx + dy * dy);
  t = std::clamp(t, Real(0), Real(1));
  return std::hypot(x[0] - Real(p[0]) - t * dx, x[1] - Real(p[1]) - t * dy);
}

/// By the angle of x seen from the centre, in complex numbers of 64 bits.
inline Real from_arc(const Point& p, const Point& q, double bulge, const Point& x) {
  using Complex = std::complex<Real>;
  const Real b = bulge;
  const Complex from(p[0], p[1]), to(q[0], q[1]), at(x[0], x[1]);
  const Complex center = (from + to) / Real(2) + (to - from) * Complex(0, (1 - b * b) / (4 * b));
  const Real turn = 4 * std::atan(b), radius = std::abs(from - center);
  Real angle = std::arg((at - center) / (from - center));  // from the start
  const Real full = 2 * std::numbers::pi_v<Real>;
  if (turn > 0 && angle < 0) angle += full;
  if (turn < 0 && angle > 0) angle -= full;
  if (std::fabs(angle) <= std::fabs(turn)) return std::fabs(std::abs(at - center) - radius);
  return std::min(std::abs(at - from), std::abs(at - to));
}

/// The distance from those edges of a contour that are segments and arcs.
inline double distance_from(const CurvedContour& contour, const Point& x) {
  Real least = INFINITY;
  for (std::size_t i = 0; i < contour.points.size(); ++i) {
    const Point &p = contour.points[i], &q = contour.points[(i + 1) % contour.points.size()];
    if (p == q || contour.edges[i].conic) continue;
    const double bulge = contour.edges[i].bulge;
    least = std::min(least, bulge != 0 ? from_arc(p, q, bulge, x) : from_segment(p, q, x));
  }
  return static_cast<double>(least);
}

/// Whether a ray to the right meets the polygon an odd number of times, in long double.
inline bool is_inside(const std::vector<Point>& polygon, const Point& x) {
  bool inside = false;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Point &p = polygon[i], &q = polygon[(i + 1) % polygon.size()];
    if ((p[1] > x[1]) == (q[1] > x[1])) continue;
    const Real t = (Real(x[1]) - p[1]) / (Real(q[1]) - p[1]);
    if (p[0] + t * (Real(q[0]) - p[0]) > x[0]) inside = !inside;
  }
  return inside;
}

/// The same for a contour of segments and arcs: the polygon of its chords, and each part of a disk
/// between an arc and its chord once more.
inline bool is_inside(const CurvedContour& contour, const Point& x) {
  bool inside = is_inside(contour.points, x);
  for (std::size_t i = 0; i < contour.points.size(); ++i) {
    const Point &p = contour.points[i], &q = contour.points[(i + 1) % contour.points.size()];
    const Real b = contour.edges[i].bulge, dx = Real(q[0]) - p[0], dy = Real(q[1]) - p[1];
    if (b == 0) continue;
    const Real u = x[0] - Real(p[0]), v = x[1] - Real(p[1]);
    const Real left = dx * v - dy * u;  // the arc lies to the right if it turns left
    if ((left < 0) != (b > 0)) continue;
    // |x − c|² − r², c = (p + q)/2 + (1 − b²)/4b (−dy, dx), relative to p.
    const Real power = u * (u - dx) + v * (v - dy) - left * (1 - b * b) / (2 * b);
    if (power < 0) inside = !inside;
  }
  return inside;
}

/// Points of a contour, `count` on each curved edge.
inline std::vector<Point> traced(const CurvedContour& contour, int count) {
  std::vector<Point> points;
  const std::size_t size = contour.points.size();
  for (std::size_t i = 0; i < size; ++i) {
    const Point &p = contour.points[i], &q = contour.points[(i + 1) % size];
    const EdgeCurve& edge = contour.edges[i];
    for (int k = 0; k < count; ++k) {
      const double t = static_cast<double>(k) / count;
      if (edge.conic) {
        const double a = (1 - t) * (1 - t), b = 2 * t * (1 - t) * edge.conic->weight, c = t * t;
        const Point& r = edge.conic->control;
        points.push_back({(a * p[0] + b * r[0] + c * q[0]) / (a + b + c),
                          (a * p[1] + b * r[1] + c * q[1]) / (a + b + c)});
      } else if (edge.bulge != 0) {
        // p + (q − p) sin(2 θ t) / sin(2 θ) turned by θ (2 t − 2) + … : in complex numbers, the
        // chord seen under the half angle.
        const double half = 2 * std::atan(edge.bulge), s = std::sin(half * t) / std::sin(half);
        const double turn = -half * (1 - t), c = std::cos(turn), d = std::sin(turn);
        const double x = q[0] - p[0], y = q[1] - p[1];
        points.push_back({p[0] + s * (c * x - d * y), p[1] + s * (d * x + c * y)});
      } else if (k == 0) {
        points.push_back(p);
      }
    }
  }
  return points;
}

inline bool crosses_itself(const CurvedContour& contour, int count) {
  const std::vector<Point> fine = traced(contour, count);
  std::vector<Segment> segments;
  std::vector<int> next;
  for (std::size_t i = 0; i < fine.size(); ++i) {
    segments.push_back({fine[i], fine[(i + 1) % fine.size()]});
    next.push_back(static_cast<int>((i + 1) % fine.size()));
  }
  return intersecting_pair(segments, next).has_value();
}

/// Stars with edges of any curvature that leaves them simple, as far as 200 chords per edge show.
inline CurvedContour random_contour(RandomPolygons& random) {
  while (true) {
    CurvedContour contour;
    contour.points = random.next(RandomPolygons::Kind::star);
    if (contour.points.size() > 14) contour.points.resize(14);
    for (std::size_t i = 0; i < contour.points.size(); ++i)
      contour.edges.push_back({random.real(0, 1) < 0.3 ? 0 : random.real(-0.8, 0.8)});
    if (!crosses_itself(contour, 200)) return contour;
  }
}

}  // namespace rfm
