#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <vector>

#include "core/box.hpp"

namespace rfm {

/// Of the point x from the segment from p to q.
inline double distance_from(const Point& p, const Point& q, const Point& x) {
  const double dx = q[0] - p[0], dy = q[1] - p[1], square = dx * dx + dy * dy;
  if (square == 0) return std::hypot(x[0] - p[0], x[1] - p[1]);
  const double t = std::clamp(((x[0] - p[0]) * dx + (x[1] - p[1]) * dy) / square, 0.0, 1.0);
  return std::hypot(x[0] - p[0] - t * dx, x[1] - p[1] - t * dy);
}

/// Simple polygons of several kinds, seeded; either way round, turned by a random angle.
class RandomPolygons {
 public:
  explicit RandomPolygons(unsigned seed) : generator_(seed) {}

  enum class Kind { star, spiral, comb, thin_star, grid, count };

  std::vector<Point> next(Kind kind) {
    std::vector<Point> points;
    switch (kind) {
      case Kind::star:
        points = star(integer(3, 200), 0.1);
        break;
      case Kind::thin_star:  // nearly degenerate: radii over six orders of magnitude, or almost
                             // equal
        points = star(integer(3, 100), real(0, 1) < 0.5 ? 1e-6 : 1 - 1e-9);
        break;
      case Kind::spiral:
        points = spiral();
        break;
      case Kind::comb:
        points = comb();
        break;
      default:
        points = staircase();
    }
    if (kind != Kind::grid && real(0, 1) < 0.7) turn(points, real(0, 2 * std::numbers::pi));
    if (real(0, 1) < 0.5) std::ranges::reverse(points);
    std::ranges::rotate(points, points.begin() + integer(0, static_cast<int>(points.size()) - 1));
    return points;
  }

  double real(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(generator_);
  }
  int integer(int low, int high) {
    return std::uniform_int_distribution<int>(low, high)(generator_);
  }

 private:
  std::vector<Point> star(int count, double smallest) {
    std::vector<double> angles;
    for (int i = 0; i < count; ++i)
      angles.push_back(2 * std::numbers::pi * (i + real(0.05, 0.95)) / count);
    std::vector<Point> points;
    for (const double angle : angles) {
      const double radius = std::pow(smallest, real(0, 1));
      points.push_back({radius * std::cos(angle), radius * std::sin(angle)});
    }
    return points;
  }

  std::vector<Point> spiral() {
    const int half = integer(5, 100);
    const double turns = real(0.3, std::min(6.0, half / 9.0)), width = real(0.1, 0.9);
    std::vector<Point> outer, inner;
    for (int i = 0; i < half; ++i) {
      const double angle = 2 * std::numbers::pi * turns * i / half;
      const double radius = 1 + angle;
      // The next winding is 2π farther out, but chords cut corners.
      const double thickness = std::min(width * 2 * std::numbers::pi, 0.3 * radius) *
                               std::cos(std::min(1.2, std::numbers::pi * turns / half));
      outer.push_back({(radius + 0.3 * thickness) * std::cos(angle),
                       (radius + 0.3 * thickness) * std::sin(angle)});
      inner.push_back({radius * std::cos(angle), radius * std::sin(angle)});
    }
    outer.insert(outer.end(), inner.rbegin(), inner.rend());
    return outer;
  }

  std::vector<Point> comb() {
    const int teeth = integer(1, 48);
    std::vector<Point> points = {{0, -1}, {static_cast<double>(teeth), -1}};
    const bool level = real(0, 1) < 0.5;
    for (int i = teeth - 1; i >= 0; --i) {
      const double top = level ? 1 : real(0.2, 3), slot = level ? 0 : real(-0.9, 0.1);
      points.push_back({i + 1.0, top});
      points.push_back({i + real(0.3, 0.6), top});
      points.push_back({i + 0.2, slot});
      points.push_back({i + 0.0, slot});
    }
    return points;
  }

  // Steps up and down over whole numbers: many collinear edges and points on edges.
  std::vector<Point> staircase() {
    const int count = integer(2, 60);
    std::vector<Point> points = {{static_cast<double>(count), -1}};
    for (int i = count - 1; i >= 0; --i) {
      const double height = integer(0, 3);
      points.push_back({i + 1.0, height});
      points.push_back({i + 0.0, height});
    }
    points.push_back({0, -1});
    return points;
  }

  static void turn(std::vector<Point>& points, double angle) {
    const double c = std::cos(angle), s = std::sin(angle);
    for (Point& p : points) p = {c * p[0] - s * p[1], s * p[0] + c * p[1]};
  }

  std::mt19937_64 generator_;
};

}  // namespace rfm
