#include "core/exact_distances.hpp"

#include <cmath>

#include "core/composition.hpp"
#include "core/contour_distance.hpp"
#include "core/ellipsoid_distance.hpp"
#include "core/error.hpp"
#include "core/mapped_region.hpp"
#include "core/primitives.hpp"
#include "core/quadric.hpp"
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

struct Ball {
  Point center{};
  double radius = 0;
  bool inside = true;  ///< whether its inside is positive
};

// Of a polynomial a |x − c|² + …, if it is one.
std::optional<Ball> as_ball(const Field& level, int dimension) {
  const auto q = as_quadric(level, dimension);
  if (!q || q->square[0] == 0) return {};
  const double a = q->square[0];
  for (int i = 0; i < dimension; ++i)
    for (int j = i; j < dimension; ++j)
      if (std::fabs(q->square[Quadric::square_index(i, j)] - (i == j ? a : 0)) >
          1e-15 * std::fabs(a))
        return {};
  Ball ball{q->origin, 0, a < 0};
  double square = -q->constant / a;
  for (int axis = 0; axis < dimension; ++axis) {
    const double shift = q->linear[axis] / (2 * a);
    ball.center[axis] -= shift;
    square += shift * shift;
  }
  if (!(square > 0)) return {};
  ball.radius = std::sqrt(square);
  return ball;
}

// What is known of the box of a shape holds for the same set with another function.
Region in_same_box(const Region& changed, const Region& region) {
  return region.enclosure() ? changed.within(*region.enclosure()) : changed;
}

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

Field box_distance(const Point& min, const Point& max, int dimension) {
  Field inside = 0.0, outside = 0.0;
  for (int axis = 0; axis < dimension; ++axis) {
    const Field nearest = rfm::min(coordinate(axis) - min[axis], max[axis] - coordinate(axis));
    inside = axis == 0 ? nearest : rfm::min(inside, nearest);
    outside = outside + pow(rfm::min(nearest, 0.0), 2.0);
  }
  return dimension == 1 ? inside : select(step(inside), inside, -sqrt(outside));
}

Field strip_distance(const Point& point, const Point& normal, double width) {
  const Region sides = strip(point, normal, width);
  return min(sides.primitives()[0]->function, sides.primitives()[1]->function);
}

Field sector_distance(const Point& center, double radius, double from, double to,
                      double inner_radius) {
  CurvedContour contour;
  const auto arc = [&](double r, double begin, double end) {
    const double middle = (begin + end) / 2, bulge = std::tan((end - begin) / 8);
    for (const double angle : {begin, middle}) {
      contour.points.push_back({center[0] + r * std::cos(angle), center[1] + r * std::sin(angle)});
      contour.edges.push_back({bulge, {}});
    }
    contour.points.push_back({center[0] + r * std::cos(end), center[1] + r * std::sin(end)});
    contour.edges.emplace_back();
  };
  arc(radius, from, to);
  if (inner_radius > 0) {
    arc(inner_radius, to, from);
  } else {
    contour.points.push_back(center);
    contour.edges.emplace_back();
  }
  return contour_distance({contour});
}

Region with_exact_sides(const Region& region) {
  const int dimension = region.dimension();
  const Region exact = mapped_region(region, [&](const Primitive& primitive) {
    Primitive changed = primitive;
    if (const auto ball = as_ball(primitive.level, dimension)) {
      const Field distance = ball_distance(ball->center, ball->radius, dimension);
      changed.function = ball->inside ? distance : -distance;
    }
    return MappedPrimitive(Region(std::move(changed), dimension));
  });
  return in_same_box(exact, region);
}

Region with_function(const Region& region, const Field& function) {
  bool first = true;
  const Region changed = mapped_region(region, [&](const Primitive& primitive) {
    Primitive changed = primitive;
    if (first) changed.function = function;
    first = false;
    return MappedPrimitive(Region(std::move(changed), region.dimension()));
  });
  return in_same_box(changed, region);
}

}  // namespace rfm
