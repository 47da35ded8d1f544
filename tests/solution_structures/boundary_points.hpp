#pragma once

#include <cmath>
#include <vector>

#include "core/box.hpp"
#include "core/field.hpp"

namespace rfm::test {

/// Points on a circle, none at a rational part of the turn; between two angles if they are given.
inline std::vector<Point> on_circle(const Point& center, double radius, double from = 0,
                                    double to = 6.2) {
  std::vector<Point> points;
  for (double t = from + 0.013; t < to; t += 0.097)
    points.push_back({center[0] + radius * std::cos(t), center[1] + radius * std::sin(t)});
  return points;
}

/// Points within a segment in the plane.
inline std::vector<Point> on_segment(const Point& from, const Point& to) {
  std::vector<Point> points;
  for (double t = 0.043; t < 0.98; t += 0.071)
    points.push_back({from[0] + t * (to[0] - from[0]), from[1] + t * (to[1] - from[1])});
  return points;
}

/// A disk with an excentric hole: normalised functions, outward normals that know nothing of them,
/// and points of the two circles.
struct Ring {
  Field x = x_coordinate(), y = y_coordinate();
  Field outer = (1 - x * x - y * y) / 2;
  Field inner = (pow(x - 0.2, 2) + pow(y - 0.1, 2) - 0.16) / 0.8;
  std::vector<Field> outer_normal{x, y};
  std::vector<Field> inner_normal{(0.2 - x) / 0.4, (0.1 - y) / 0.4};
  std::vector<Point> outer_points = on_circle({0, 0}, 1);
  std::vector<Point> inner_points = on_circle({0.2, 0.1}, 0.4);
};

/// l·∇u in the plane.
inline Field along(const std::vector<Field>& direction, const Field& u) {
  return direction[0] * partial(u, 0) + direction[1] * partial(u, 1);
}

}  // namespace rfm::test
