#include "core/primitives.hpp"

#include <cmath>

#include "core/error.hpp"

namespace rfm {
namespace {

Region unnamed(const Field& function, const Field& level, int dimension) {
  return Region(Primitive{"", function, level}, dimension);
}

void require_positive(double size, const char* what) {
  if (!(size > 0))
    throw InvalidArgument(std::string(what) + " must be positive, got " + std::to_string(size));
}

}  // namespace

Region half_plane(const Point& point, const Point& normal) {
  const double length = std::hypot(normal[0], normal[1]);
  require_positive(length, "the length of a normal");
  const double nx = normal[0] / length, ny = normal[1] / length;
  const Field distance =
      nx * x_coordinate() + ny * y_coordinate() - (nx * point[0] + ny * point[1]);
  return unnamed(distance, distance, 2);
}

Region circle(const Point& center, double radius) {
  require_positive(radius, "the radius of a circle");
  const Field x = x_coordinate() - center[0], y = y_coordinate() - center[1];
  const Field function = (radius * radius - x * x - y * y) * (0.5 / radius);
  return unnamed(function, function, 2);
}

Region ellipse(const Point& center, const Point& radii, double angle) {
  require_positive(radii[0], "a radius of an ellipse");
  require_positive(radii[1], "a radius of an ellipse");
  const double cosine = std::cos(angle), sine = std::sin(angle);
  const Field x = x_coordinate() - center[0], y = y_coordinate() - center[1];
  const Field xi = (cosine * x + sine * y) / radii[0], eta = (cosine * y - sine * x) / radii[1];
  const Field level = 1.0 - xi * xi - eta * eta;
  return unnamed(normalize(level, 2), level, 2);
}

Region box(const Point& min, const Point& max, int dimension) {
  constexpr const char* names[] = {"left", "right", "bottom", "top", "back", "front"};
  const auto side = [&](const char* name, const Field& distance) {
    return Region(Primitive{name, distance, distance}, dimension);
  };
  for (int axis = 0; axis < dimension; ++axis)
    require_positive(max[axis] - min[axis], "a side of a box");
  Region region = side(names[0], x_coordinate() - min[0]) & side(names[1], max[0] - x_coordinate());
  for (int axis = 1; axis < dimension; ++axis)
    region = region & side(names[2 * axis], coordinate(axis) - min[axis]) &
             side(names[2 * axis + 1], max[axis] - coordinate(axis));
  return region;
}

Region level_set(const Field& f, int dimension) { return unnamed(f, f, dimension); }

}  // namespace rfm
