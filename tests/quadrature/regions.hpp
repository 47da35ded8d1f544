#pragma once

#include <cmath>
#include <numbers>

#include "core/grid.hpp"
#include "core/region.hpp"

/// Regions of known measure for tests of quadrature.
namespace rfm::test {

inline constexpr double pi = std::numbers::pi;

inline Region region_of(const Field& level, int dimension, const std::string& name = "w") {
  return Region(Primitive{name, level, level}, dimension);
}

inline Field x() { return x_coordinate(); }
inline Field y() { return y_coordinate(); }
inline Field z() { return z_coordinate(); }
inline Field square(const Field& f) { return f * f; }

/// {(x − a)² + (y − b)² ≤ r²}
inline Region disk(double a, double b, double r) {
  return region_of(r * r - square(x() - a) - square(y() - b), 2, "disk");
}
/// {c + a x + b y ≥ 0}
inline Region half_plane(double a, double b, double c) {
  return region_of(a * x() + b * y() + c, 2, "line");
}
/// The square of half side `half` turned by `angle`.
inline Region turned_square(double half, double angle, double a = 0, double b = 0) {
  const double c = std::cos(angle), s = std::sin(angle);
  const auto side = [&](double nx, double ny) {
    return half_plane(-nx, -ny, half + nx * a + ny * b);
  };
  return side(c, s) & side(-s, c) & side(-c, -s) & side(s, -c);
}
/// The five-pointed star bounded by five lines at distance `apothem` from the origin: at most one
/// of the lines is violated.
inline Region star(double apothem, double angle) {
  std::vector<Region> sides;
  for (int k = 0; k < 5; ++k) {
    const double t = angle + 2 * pi * k / 5;
    sides.push_back(half_plane(-std::cos(t), -std::sin(t), apothem));
  }
  const auto all_but = [&](int left_out) {
    Region rest = sides[(left_out + 1) % 5];
    for (int k = 2; k < 5; ++k) rest = rest & sides[(left_out + k) % 5];
    return rest;
  };
  Region result = all_but(0);
  for (int k = 1; k < 5; ++k) result = result | all_but(k);
  return result;
}
/// Its area: the inner pentagon and five triangles on its edges.
inline double star_area(double apothem) {
  const double edge = 2 * apothem * std::tan(pi / 5);
  const double height = 0.5 * edge * std::tan(2 * pi / 5);
  return 5 * 0.5 * edge * apothem + 5 * 0.5 * edge * height;
}
inline double star_perimeter(double apothem) {
  return 10 * apothem * std::tan(pi / 5) / std::cos(2 * pi / 5);
}

/// The square grid [−half, half]² (cube in 3D) of n cells a side.
inline Grid grid(double half, int n, int dimension = 2) {
  Box box;
  box.dimension = dimension;
  for (int axis = 0; axis < dimension; ++axis) {
    box.low[axis] = -half;
    box.high[axis] = half;
  }
  return Grid(box, {n, n, n});
}

}  // namespace rfm::test
