#include "core/surroundings.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/boolean_simplification.hpp"
#include "core/point_algebra.hpp"

namespace rfm {
namespace {

using std::numbers::pi;

std::vector<Point> directions_on_a_line() { return {{1, 0, 0}, {-1, 0, 0}}; }

// Between all tangents, and 64 of a circle.
std::vector<Point> directions_in_the_plane(const std::vector<Point>& normals) {
  std::vector<double> angles;
  for (const Point& n : normals)
    for (const double sign : {1.0, -1.0}) angles.push_back(std::atan2(sign * n[0], -sign * n[1]));
  std::ranges::sort(angles);
  std::vector<Point> directions;
  const auto add = [&](double angle) {
    directions.push_back({std::cos(angle), std::sin(angle), 0});
  };
  for (std::size_t i = 0; i < angles.size(); ++i) {
    const double next = i + 1 < angles.size() ? angles[i + 1] : angles[0] + 2 * pi;
    if (next - angles[i] > 1e-9) add(0.5 * (angles[i] + next));
  }
  for (int i = 0; i < 64; ++i) add(0.1 + 2 * pi * i / 64);
  return directions;
}

// Every cell of an arrangement of planes through a point touches a line where two of them meet:
// the four sides of each such line, and 128 directions spread over the sphere.
std::vector<Point> directions_in_space(const std::vector<Point>& normals) {
  std::vector<Point> directions;
  const auto add = [&](const Point& d) {
    const double size = norm(d);
    directions.push_back({d[0] / size, d[1] / size, d[2] / size});
  };
  for (std::size_t i = 0; i < normals.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) {
      const Point line = cross(normals[i], normals[j]);
      const double sine = norm(line);
      if (sine < 1e-6) continue;
      for (int side = 0; side < 8; ++side) {
        const double along = (side & 1) != 0 ? 1 : -1;
        const double p = (side & 2) != 0 ? 1e-2 : -1e-2, q = (side & 4) != 0 ? 1e-2 : -1e-2;
        Point d;
        for (int axis = 0; axis < 3; ++axis)
          d[axis] = along * line[axis] / sine + p * normals[i][axis] + q * normals[j][axis];
        add(d);
      }
    }
  const double golden = pi * (3 - std::sqrt(5.0));
  for (int i = 0; i < 128; ++i) {
    const double z = 1 - (2 * i + 1) / 128.0, r = std::sqrt(1 - z * z);
    add({r * std::cos(golden * i), r * std::sin(golden * i), z});
  }
  return directions;
}

}  // namespace

Surroundings surroundings(const RegionEvaluator& region, const Point& point, double tolerance,
                          double reach) {
  Surroundings result;
  std::vector<Point> normals;
  for (int k = 0; k < region.primitive_count(); ++k) {
    Point gradient;
    const double value = region.level(k).value_and_gradient(point, gradient);
    const double slope = norm(gradient);
    if (std::fabs(value) > tolerance * std::max(slope, tolerance)) {
      result.signs.push_back(value > 0 ? Truth::yes : Truth::no);
      continue;
    }
    result.signs.push_back(Truth::unknown);
    result.vanishing.push_back(k);
    if (slope > 0)
      normals.push_back({gradient[0] / slope, gradient[1] / slope, gradient[2] / slope});
  }
  const Truth here = region.region().expression().evaluate(result.signs);
  if (here != Truth::unknown) {
    result.any_inside = here == Truth::yes;
    result.any_outside = here == Truth::no;
    return result;
  }
  const BooleanExpression open = with_known_signs(region.region().expression(), result.signs);
  const std::vector<Point> directions = region.dimension() == 1   ? directions_on_a_line()
                                        : region.dimension() == 2 ? directions_in_the_plane(normals)
                                                                  : directions_in_space(normals);
  std::vector<Truth> signs = result.signs;
  for (const Point& d : directions) {
    Point beside = point;
    for (int axis = 0; axis < region.dimension(); ++axis) beside[axis] += reach * d[axis];
    for (const int k : result.vanishing)
      signs[k] = region.level(k).value(beside) >= 0 ? Truth::yes : Truth::no;
    (open.evaluate(signs) == Truth::yes ? result.any_inside : result.any_outside) = true;
  }
  return result;
}

}  // namespace rfm
