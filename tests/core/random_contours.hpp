#pragma once

#include <cmath>
#include <vector>

#include "core/contour.hpp"
#include "core/curved_contour.hpp"
#include "tests/core/random_polygons.hpp"

namespace rfm {

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
