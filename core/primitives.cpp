#include "core/primitives.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/error.hpp"
#include "core/normalization_length.hpp"
#include "core/same_sign.hpp"
#include "core/sector_sides.hpp"
#include "core/segment_distance.hpp"

namespace rfm {
namespace {

Region unnamed(const Field& function, const Field& level, int dimension) {
  return Region(Primitive{"", function, level}, dimension);
}

void require_positive(double size, const char* what) {
  if (!(size > 0))
    throw InvalidArgument(std::string(what) + " must be positive, got " + std::to_string(size));
}

// x − center, component by component.
std::array<Field, 3> offset_from(const Point& center) {
  return {x_coordinate() - center[0], y_coordinate() - center[1], z_coordinate() - center[2]};
}

Field dot(const std::array<Field, 3>& a, const Point& b) {
  return b[0] * a[0] + b[1] * a[1] + b[2] * a[2];
}

Field square_length(const std::array<Field, 3>& a) {
  return a[0] * a[0] + a[1] * a[1] + a[2] * a[2];
}

Point unit(const Point& direction, const char* what) {
  const double length = std::hypot(direction[0], direction[1], direction[2]);
  require_positive(length, what);
  return {direction[0] / length, direction[1] / length, direction[2] / length};
}

// How far a disk of radius 1 across a unit vector reaches along an axis.
double across(const Point& direction, int axis) {
  return std::sqrt(std::max(0.0, 1 - direction[axis] * direction[axis]));
}

// What reaches as far on both sides of `center` along each axis.
template <class Reach>
Box box_about(const Point& center, int dimension, Reach&& reach) {
  Box box{dimension, center, center};
  for (int axis = 0; axis < dimension; ++axis) {
    box.low[axis] -= reach(axis);
    box.high[axis] += reach(axis);
  }
  return box;
}

void add(const Point& point, Box& box) {
  for (int axis = 0; axis < box.dimension; ++axis) {
    box.low[axis] = std::min(box.low[axis], point[axis]);
    box.high[axis] = std::max(box.high[axis], point[axis]);
  }
}

Box joined(Box a, const Box& b) {
  add(b.low, a);
  add(b.high, a);
  return a;
}

Region named_side(const char* name, const Field& function, const Field& level) {
  return Region(Primitive{name, function, level}, 3);
}

Region selector(const char* name, const Field& function) {
  return Region(Primitive{name, function, function, true}, 3);
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
  return unnamed(function, function, 2).within(box_about(center, 2, [&](int) { return radius; }));
}

Region ellipse(const Point& center, const Point& radii, double angle) {
  require_positive(radii[0], "a radius of an ellipse");
  require_positive(radii[1], "a radius of an ellipse");
  const double cosine = std::cos(angle), sine = std::sin(angle);
  const Field x = x_coordinate() - center[0], y = y_coordinate() - center[1];
  const Field xi = (cosine * x + sine * y) / radii[0], eta = (cosine * y - sine * x) / radii[1];
  const Field level = 1.0 - xi * xi - eta * eta;
  const Box box = box_about(center, 2, [&](int axis) {
    return axis == 0 ? std::hypot(radii[0] * cosine, radii[1] * sine)
                     : std::hypot(radii[0] * sine, radii[1] * cosine);
  });
  return unnamed(normalize_within(level, std::min(radii[0], radii[1]), 2), level, 2).within(box);
}

Region strip(const Point& point, const Point& normal, double width) {
  require_positive(width, "the width of a strip");
  const double length = std::hypot(normal[0], normal[1]);
  require_positive(length, "the length of a normal");
  const double nx = normal[0] / length, ny = normal[1] / length;
  const Point back{point[0] - width / 2 * nx, point[1] - width / 2 * ny};
  const Point forth{point[0] + width / 2 * nx, point[1] + width / 2 * ny};
  return half_plane(back, {nx, ny}).named("low") & half_plane(forth, {-nx, -ny}).named("high");
}

Region sector(const Point& center, double radius, double from, double to, double inner_radius) {
  require_positive(to - from, "the angle of a sector");
  require_positive(2 * std::numbers::pi - (to - from), "360 degrees minus the angle of a sector");
  require_positive(radius - inner_radius, "the radius of a sector minus the inner one");
  const Region left = half_plane(center, {-std::sin(from), std::cos(from)}).named("from");
  const Region right = half_plane(center, {std::sin(to), -std::cos(to)}).named("to");
  const std::optional<Region> half = straight_side(center, from, to);
  const Region wedge = half ? *half : to - from < std::numbers::pi ? left & right : left | right;
  // The arc is farthest at its ends or along an axis, and the rest at the inner radius.
  const auto at = [&](double r, double angle) {
    return Point{center[0] + r * std::cos(angle), center[1] + r * std::sin(angle)};
  };
  Box enclosure{2, at(radius, from), at(radius, from)};
  add(at(radius, to), enclosure);
  for (const double r : {radius, inner_radius}) {
    constexpr double quarter = std::numbers::pi / 2;
    for (double k = std::ceil(from / quarter); k * quarter <= to; ++k) {
      const Point farthest[] = {{r, 0}, {0, r}, {-r, 0}, {0, -r}};
      const Point& step = farthest[static_cast<int>(k - 4 * std::floor(k / 4))];
      add({center[0] + step[0], center[1] + step[1]}, enclosure);
    }
    add(at(r, from), enclosure);
    add(at(r, to), enclosure);
  }
  const Region disk = circle(center, radius).named("arc") & wedge;
  const Region whole = inner_radius > 0 ? disk - circle(center, inner_radius).named("inner") : disk;
  return whole.within(enclosure);
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
  return region.within({dimension, min, max});
}

Region half_space(const Point& point, const Point& normal) {
  const Point n = unit(normal, "the length of a normal");
  const Field distance = dot(offset_from(point), n);
  return unnamed(distance, distance, 3);
}

Region sphere(const Point& center, double radius) {
  require_positive(radius, "the radius of a sphere");
  const Field function = (radius * radius - square_length(offset_from(center))) * (0.5 / radius);
  return unnamed(function, function, 3).within(box_about(center, 3, [&](int) { return radius; }));
}

Region ellipsoid(const Point& center, const Point& radii, const Point& axis, double angle) {
  const Point a = unit(axis, "the length of an axis");
  const auto d = offset_from(center);
  const double cosine = std::cos(angle), sine = std::sin(angle);
  Field level = 1.0;
  Point reach{};
  for (int i = 0; i < 3; ++i) {
    require_positive(radii[i], "a radius of an ellipsoid");
    // The turned unit vector eᵢ, by Rodrigues' formula.
    Point e{};
    e[i] = 1;
    const double along = a[i] * (1 - cosine);
    const Point cross{a[1] * e[2] - a[2] * e[1], a[2] * e[0] - a[0] * e[2],
                      a[0] * e[1] - a[1] * e[0]};
    Point turned;
    for (int k = 0; k < 3; ++k) {
      turned[k] = cosine * e[k] + sine * cross[k] + along * a[k];
      reach[k] = std::hypot(reach[k], radii[i] * turned[k]);
    }
    const Field xi = dot(d, turned) / radii[i];
    level = level - xi * xi;
  }
  const double least = std::min({radii[0], radii[1], radii[2]});
  return unnamed(normalize_within(level, least, 3), level, 3)
      .within(box_about(center, 3, [&](int axis) { return reach[axis]; }));
}

Region cylinder(const Point& center, const Point& axis, double radius, double length) {
  require_positive(radius, "the radius of a cylinder");
  require_positive(length, "the length of a cylinder");
  const Point a = unit(axis, "the length of an axis");
  const auto d = offset_from(center);
  const Field height = dot(d, a);
  const Field side = (radius * radius - (square_length(d) - height * height)) * (0.5 / radius);
  const Region infinite = named_side("side", side, side);
  if (!std::isfinite(length)) return infinite;
  const Field start = height + 0.5 * length, end = 0.5 * length - height;
  const Region closed = infinite & named_side("start", start, start) & named_side("end", end, end);
  return closed.within(box_about(center, 3, [&](int axis) {
    return 0.5 * length * std::fabs(a[axis]) + radius * across(a, axis);
  }));
}

Region cone(const Point& apex, const Point& axis, double half_angle, double length) {
  require_positive(half_angle, "the half angle of a cone");
  require_positive(std::numbers::pi / 2 - half_angle, "90 degrees minus the half angle of a cone");
  require_positive(length, "the length of a cone");
  const Point a = unit(axis, "the length of an axis");
  const auto d = offset_from(apex);
  const Field height = dot(d, a);
  const double cosine = std::cos(half_angle);
  // (h sin)² − cos² (|d|² − h²), with sin² + cos² = 1.
  const Field level = height * height - (cosine * cosine) * square_length(d);
  const Region nappe =
      named_side("side", normalize_within(level, std::numeric_limits<double>::infinity(), 3),
                 level) &
      selector("apex", height);
  if (!std::isfinite(length)) return nappe;
  const Field end = length - height;
  Point middle;
  for (int axis = 0; axis < 3; ++axis) middle[axis] = apex[axis] + length * a[axis];
  Box box = box_about(middle, 3,
                      [&](int axis) { return length * std::tan(half_angle) * across(a, axis); });
  add(apex, box);
  return (nappe & named_side("end", end, end)).within(box);
}

Region torus(const Point& center, const Point& axis, double radius, double tube) {
  require_positive(tube, "the radius of a tube");
  require_positive(radius - tube, "the radius of a torus minus that of its tube");
  const Point a = unit(axis, "the length of an axis");
  const auto d = offset_from(center);
  const Field height = dot(d, a), square = square_length(d);
  const Field level = 4 * radius * radius * (square - height * height) -
                      pow(square + (radius * radius - tube * tube), 2.0);
  return unnamed(normalize_within(level, tube, 3), level, 3)
      .within(box_about(center, 3, [&](int axis) { return radius * across(a, axis) + tube; }));
}

Region capsule(const Point& from, const Point& to, double radius) {
  require_positive(radius, "the radius of a capsule");
  const Field square = field(std::make_shared<const SegmentDistance>(from, to));
  const Field function = (radius * radius - square) * (0.5 / radius);
  const auto ball = [&](int) { return radius; };
  return unnamed(function, function, 3)
      .within(joined(box_about(from, 3, ball), box_about(to, 3, ball)));
}

Region quadric(const std::vector<double>& coefficients, int dimension) {
  const std::size_t expected = dimension == 2 ? 6 : 10;
  if (dimension < 2 || dimension > 3 || coefficients.size() != expected)
    throw InvalidArgument("a quadric has 6 coefficients in the plane and 10 in space, got " +
                          std::to_string(coefficients.size()));
  bool varies = false;
  for (std::size_t i = 0; i < expected; ++i) {
    if (!std::isfinite(coefficients[i]))
      throw InvalidArgument("the coefficients of a quadric must be finite");
    varies = varies || (i + 1 < expected && coefficients[i] != 0);
  }
  if (!varies) throw InvalidArgument("a quadric without terms in the coordinates is constant");
  const Field x = x_coordinate(), y = y_coordinate(), z = z_coordinate();
  const std::vector<Field> terms =
      dimension == 2 ? std::vector<Field>{x * x, x * y, y * y, x, y, 1.0}
                     : std::vector<Field>{x * x, y * y, z * z, x * y, x * z, y * z, x, y, z, 1.0};
  Field level = 0.0;
  for (std::size_t i = 0; i < expected; ++i) level = level + coefficients[i] * terms[i];
  return unnamed(normalize_by_itself(level, dimension), level, dimension);
}

Region level_set(const Field& f, int dimension) {
  return unnamed(f, simplest_of_same_sign(f), dimension);
}

}  // namespace rfm
