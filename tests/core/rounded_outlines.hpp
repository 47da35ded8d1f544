#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "core/box.hpp"
#include "tests/core/random_polygons.hpp"

namespace rfm {

inline Point rounded(const Point& p, double unit) {
  return {std::round(p[0] / unit) * unit, std::round(p[1] / unit) * unit};
}

/// Points of the outline of a polygon whose corners are rounded: three to six on each arc, up to
/// eight inside each side.
inline std::vector<Point> filleted(const std::vector<Point>& corners, double radius,
                                   RandomPolygons& random) {
  struct Fillet {
    Point start, end, center;
    double radius, angle, turn;
  };
  std::vector<Fillet> fillets;
  const std::size_t count = corners.size();
  for (std::size_t i = 0; i < count; ++i) {
    const Point &before = corners[(i + count - 1) % count], &at = corners[i],
                &after = corners[(i + 1) % count];
    const double in = std::hypot(at[0] - before[0], at[1] - before[1]),
                 out = std::hypot(after[0] - at[0], after[1] - at[1]);
    const Point u{(at[0] - before[0]) / in, (at[1] - before[1]) / in},
        v{(after[0] - at[0]) / out, (after[1] - at[1]) / out};
    const double turn = std::atan2(u[0] * v[1] - u[1] * v[0], u[0] * v[0] + u[1] * v[1]);
    const double tangent = std::tan(std::fabs(turn) / 2);
    const double r = std::min(radius, 0.4 * std::min(in, out) / tangent), t = r * tangent;
    const double left = turn > 0 ? r : -r;
    const Point start{at[0] - t * u[0], at[1] - t * u[1]};
    const Point center{start[0] - left * u[1], start[1] + left * u[0]};
    fillets.push_back({start,
                       {at[0] + t * v[0], at[1] + t * v[1]},
                       center,
                       r,
                       std::atan2(start[1] - center[1], start[0] - center[0]),
                       turn});
  }
  std::vector<Point> points;
  for (std::size_t i = 0; i < count; ++i) {
    const Fillet &fillet = fillets[i], &next = fillets[(i + 1) % count];
    const int on_arc = random.integer(3, 6), on_side = random.integer(1, 9);
    for (int k = 0; k <= on_arc; ++k) {
      const double angle = fillet.angle + fillet.turn * k / on_arc;
      points.push_back({fillet.center[0] + fillet.radius * std::cos(angle),
                        fillet.center[1] + fillet.radius * std::sin(angle)});
    }
    for (int k = 1; k < on_side; ++k)
      points.push_back({fillet.end[0] + (next.start[0] - fillet.end[0]) * k / on_side,
                        fillet.end[1] + (next.start[1] - fillet.end[1]) * k / on_side});
  }
  return points;
}

/// A rectangle, an L, an I, a triangle, a regular polygon or a star.
inline std::vector<Point> angular_outline(RandomPolygons& random) {
  const double a = random.real(0.6, 2), b = random.real(0.6, 2);
  const auto around = [](int count, double inner) {
    std::vector<Point> points;
    for (int i = 0; i < count; ++i) {
      const double r = i % 2 ? inner : 1, angle = 2 * std::numbers::pi * i / count;
      points.push_back({r * std::cos(angle), r * std::sin(angle)});
    }
    return points;
  };
  switch (random.integer(0, 5)) {
    case 0:
      return {{0, 0}, {a, 0}, {a, b}, {0, b}};
    case 1: {
      const double c = a * random.real(0.2, 0.6), d = b * random.real(0.2, 0.6);
      return {{0, 0}, {a, 0}, {a, d}, {c, d}, {c, b}, {0, b}};
    }
    case 2: {
      const double t = 0.2 * a, u = 0.2 * b, left = (a - t) / 2, right = (a + t) / 2;
      return {{0, 0}, {a, 0}, {a, u},     {right, u},    {right, b - u}, {a, b - u},
              {a, b}, {0, b}, {0, b - u}, {left, b - u}, {left, u},      {0, u}};
    }
    case 3:
      return {{0, 0}, {a, 0}, {random.real(0.2, 0.8) * a, b}};
    case 4:
      return around(random.integer(5, 9), 1);
    default:
      return around(2 * random.integer(4, 8), 0.5);
  }
}

struct RoundedOutline {
  std::vector<Point> points;
  double unit;
};

/// Points of a filleted outline of any size, turned, and rounded to `factor` times a power of ten
/// from 10⁻² to 10⁻¹² of the size.
inline RoundedOutline rounded_outline(RandomPolygons& random, double factor) {
  const double scales[] = {1, 1, 25.4, 1000, 0.01};
  const double scale = scales[random.integer(0, 4)];
  const double unit = factor * std::pow(10, std::ceil(std::log10(scale)) - random.integer(2, 12));
  const std::vector<Point> corners = angular_outline(random);
  const double turn = random.integer(0, 3) == 0 ? 0 : random.real(0, 3);
  const double c = scale * std::cos(turn), s = scale * std::sin(turn);
  RoundedOutline outline{{}, unit};
  for (const Point& p : filleted(corners, random.real(0.05, 0.3), random))
    outline.points.push_back(rounded({c * p[0] - s * p[1], s * p[0] + c * p[1]}, unit));
  return outline;
}

}  // namespace rfm
