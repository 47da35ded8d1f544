#include "core/exact_distances.hpp"

#include <cmath>

#include "core/composition.hpp"
#include "core/ellipsoid_distance.hpp"
#include "core/error.hpp"
#include "core/mapped_region.hpp"
#include "core/segment_distance.hpp"

namespace rfm {
namespace {

// About an axis: the square of the distance from it, and the height along it.
struct AboutAxis {
  Field square = 0.0, height = 0.0;

  AboutAxis(const Point& center, const Point& axis) {
    const double length = std::hypot(axis[0], axis[1], axis[2]);
    if (!(length > 0)) throw InvalidArgument("an axis of length 0 has no direction");
    Field all = 0.0;
    for (int i = 0; i < 3; ++i) {
      const Field offset = coordinate(i) - center[i];
      all = all + offset * offset;
      height = height + axis[i] / length * offset;
    }
    square = all - height * height;
  }
  // Rounding may put it below zero on the axis.
  Field distance() const { return sqrt(max(square, 0.0)); }
};

}  // namespace

Field ball_distance(const Point& center, double radius, int dimension) {
  Field square = 0.0;
  for (int axis = 0; axis < dimension; ++axis)
    square = square + pow(coordinate(axis) - center[axis], 2.0);
  return radius - sqrt(square);
}

Field cylinder_distance(const Point& center, const Point& axis, double radius) {
  return radius - AboutAxis(center, axis).distance();
}

Field cone_distance(const Point& apex, const Point& axis, double half_angle) {
  const AboutAxis about(apex, axis);
  return std::sin(half_angle) * about.height - std::cos(half_angle) * about.distance();
}

Field torus_distance(const Point& center, const Point& axis, double radius, double tube) {
  const AboutAxis about(center, axis);
  return tube - hypot(about.distance() - radius, about.height);
}

Field capsule_distance(const Point& from, const Point& to, double radius) {
  return radius - sqrt(field(std::make_shared<const SegmentDistance>(from, to)));
}

Field ellipsoid_distance(const Point& radii, int dimension) {
  return field(std::make_shared<const EllipsoidDistance>(radii, dimension));
}

Field ellipsoid_distance(const Point& center, const Point& radii, const Point& axis, double angle,
                         int dimension) {
  const Region own(Primitive{"", ellipsoid_distance(radii, dimension), 0.0}, dimension);
  return transformed(own, {1, angle, axis, center, {}}).primitives()[0]->function;
}

Region with_function(const Region& region, const Field& function) {
  bool first = true;
  return mapped_region(region, [&](const Primitive& primitive) {
    Primitive changed = primitive;
    if (first) changed.function = function;
    first = false;
    return MappedPrimitive(Region(std::move(changed), region.dimension()));
  });
}

}  // namespace rfm
