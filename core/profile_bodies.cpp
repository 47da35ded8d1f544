#include "core/profile_bodies.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/bounding_box.hpp"
#include "core/composition.hpp"
#include "core/error.hpp"
#include "core/even_and_odd.hpp"
#include "core/mapped_region.hpp"
#include "core/normalization_length.hpp"
#include "core/primitives.hpp"
#include "core/quadric.hpp"

namespace rfm {
namespace {

void require_plane(const Region& profile) {
  if (profile.dimension() != 2)
    throw InvalidArgument("a profile is a plane shape, not one of " +
                          std::to_string(profile.dimension()) + " dimensions");
}

// The axis of revolution: the square of the distance from it, and the height along it.
struct Meridian {
  Field square, height;
};

Meridian meridian(const Point& center, const Point& axis) {
  const double length = std::hypot(axis[0], axis[1], axis[2]);
  if (!(length > 0)) throw InvalidArgument("an axis of length 0 has no direction");
  Field square = 0.0, height = 0.0;
  for (int i = 0; i < 3; ++i) {
    const Field offset = coordinate(i) - center[i];
    square = square + offset * offset;
    height = height + axis[i] / length * offset;
  }
  return {square - height * height, height};
}

Region side(const std::string& name, const Field& function, const Field& level) {
  return Region(Primitive{name, function, level}, 3);
}

// Normalised as the others are, so that R-functions of both are of lengths.
Region selector(const std::string& name, const Field& level, double length) {
  return Region(Primitive{name.empty() ? "axis" : name + ".axis",
                          normalize_by_itself(level, 3, length), level, true},
                3);
}

// P = E + xO for P of degree 2: E = xx·x² + q(y), O = slope·y + shift, y from the quadric's origin.
struct EvenAndOdd {
  double xx, yy, y1, constant, slope, shift, origin;

  explicit EvenAndOdd(const Quadric& q)
      : xx(q.square[0]),
        yy(q.square[3]),
        y1(q.linear[1] - 2 * q.square[1] * q.origin[0]),
        constant(q.constant + q.origin[0] * (xx * q.origin[0] - q.linear[0])),
        slope(2 * q.square[1]),
        shift(q.linear[0] - 2 * xx * q.origin[0]),
        origin(q.origin[1]) {
    // What was meant to be on the axis, or along it, may have been rounded.
    const double curvature = std::fabs(xx) + std::fabs(yy) + std::fabs(slope);
    const double reach = curvature > 0 ? std::sqrt(std::fabs(q.constant) / curvature) : 0.0;
    const double size =
        std::fabs(q.linear[0]) + std::fabs(q.linear[1]) + curvature * (reach + std::fabs(origin));
    for (double* term : {&y1, &shift})
      if (std::fabs(*term) <= 1e-15 * size) *term = 0;
    if (std::fabs(slope) <= 1e-15 * curvature) slope = 0;
  }

  // Bounds of E for all ρ and heights.
  Interval even_range() const {
    constexpr double infinite = std::numeric_limits<double>::infinity();
    Interval range(constant, constant);
    if (yy != 0) {
      const double extreme = constant - y1 * y1 / (4 * yy);
      range = yy > 0 ? Interval(extreme, infinite) : Interval(-infinite, extreme);
    } else if (y1 != 0) {
      range = Interval::entire();
    }
    if (xx > 0) range.high = infinite;
    if (xx < 0) range.low = -infinite;
    return range;
  }
  bool even_is_constant() const { return xx == 0 && yy == 0 && y1 == 0; }
};

MappedPrimitive even_side(const Primitive& primitive, const EvenAndOdd& parts, const Field& even,
                          double length) {
  const Interval range = parts.even_range();
  if (range.low >= 0) return MappedPrimitive(true);
  if (range.high < 0) return MappedPrimitive(false);
  const bool as_it_is = primitive.function.same_as(primitive.level);
  return side(primitive.name, as_it_is ? even : normalize_by_itself(even, 3, length), even);
}

// E + ρO ≥ 0 by squares: ρ²O² − E² ("outer"), and the signs of E and O where they are needed.
MappedPrimitive squared_side(const std::string& name, const EvenAndOdd& parts, const Field& even,
                             const Meridian& at, double length) {
  const Field odd = parts.slope * (at.height - parts.origin) + parts.shift;
  Field level = at.square * pow(odd, 2.0) - pow(even, 2.0);
  if (parts.slope == 0 && parts.even_is_constant())  // a cylinder: a polynomial, normalised
    level = level / (2 * std::fabs(parts.shift * parts.constant));
  const auto bounding = [&](const Field& squares) {
    return side(name, parts.even_is_constant() ? squares : normalize_within(squares, length, 3),
                squares);
  };
  const Interval range = parts.even_range();
  const Region plus = selector(name, even, length);
  if (parts.slope == 0 && parts.shift > 0) {
    if (range.low >= 0) return MappedPrimitive(true);
    return range.high <= 0 ? bounding(level) : bounding(level) | plus;
  }
  if (parts.slope == 0) {
    if (range.high <= 0) return MappedPrimitive(false);
    return range.low >= 0 ? bounding(-level) : bounding(-level) & plus;
  }
  const Region outer = bounding(level), positive = selector(name, odd, length);
  return ((outer | plus) & positive) | (plus & !positive & !outer);
}

// E + ρO ≥ 0 for any E and O: as above where nothing is known of them.
MappedPrimitive squared_side(const std::string& name, const EvenAndOddParts& parts,
                             const Meridian& at, double length) {
  const Field level = at.square * pow(parts.odd, 2.0) - pow(parts.even, 2.0);
  const Region outer = side(name, normalize_within(level, length, 3), level);
  const Region plus = selector(name, parts.even, length),
               positive = selector(name, parts.odd, length);
  return ((outer | plus) & positive) | (plus & !positive & !outer);
}

Region joining_smoothly(const Region& region) {
  return mapped_region(region, [&](const Primitive& primitive) {
    Primitive marked = primitive;
    marked.joins_smoothly = !marked.selects_only;
    return MappedPrimitive(Region(std::move(marked), region.dimension()));
  });
}

// Whether the closed profile keeps off the axis, proved by bounds.
bool keeps_off_axis(const Region& profile) {
  constexpr double infinite = std::numeric_limits<double>::infinity();
  const Box axis{2, {0, -infinite}, {0, infinite}};
  return RegionEvaluator(profile).contains(axis) == Truth::no;
}

// How far a bounded region of the plane reaches in the direction (across, along).
double reach_of(const Region& region, double across, double along) {
  Similarity turn;
  turn.angle = -std::atan2(along, across);
  return bounding_box(RegionEvaluator(transformed(region, turn))).high[0];
}

// The box around a bounded profile turned about the axis. The points of the circle that a point
// (ρ, h) of the profile becomes reach aᵢh + √(1 − aᵢ²) ρ along axis i: so far as the profile does
// in a direction of its own plane. Throws `InvalidArgument` for a profile without points at x ≥ 0.
Box turned_box(const Region& profile, const Point& center, const Point& axis) {
  const double length = std::hypot(axis[0], axis[1], axis[2]);
  const Region half = (profile & half_plane({0, 0}, {1, 0})).within(*profile.enclosure());
  const Box plane = bounding_box(RegionEvaluator(half));
  Box box{3, center, center};
  for (int i = 0; i < 3; ++i) {
    const double along = axis[i] / length, across = std::sqrt(std::max(0.0, 1 - along * along));
    if (along == 0 || across == 0) {
      box.low[i] +=
          across == 0 ? std::min(along * plane.low[1], along * plane.high[1]) : -plane.high[0];
      box.high[i] +=
          across == 0 ? std::max(along * plane.low[1], along * plane.high[1]) : plane.high[0];
    } else {
      box.low[i] -= reach_of(half, across, -along);
      box.high[i] += reach_of(half, across, along);
    }
  }
  return box;
}

MappedPrimitive revolved(const Primitive& primitive, const Meridian& at, bool off_axis,
                         double size) {
  const std::optional<Quadric> q = as_quadric(primitive.level, 2);
  const double length = q ? length_of(*q) : size;
  if (q) {
    const EvenAndOdd parts(*q);
    const Field y = at.height - parts.origin;
    const Field even = parts.xx * at.square + parts.yy * y * y + parts.y1 * y + parts.constant;
    if (parts.slope == 0 && parts.shift == 0) return even_side(primitive, parts, even, length);
    return squared_side(primitive.name, parts, even, at, length);
  }
  // Elsewhere in ρ² as far as the expression shows it to be even.
  const auto parts = even_and_odd(primitive.level, at.square, at.height);
  if (parts && parts->is_even()) {
    const auto function = even_and_odd(primitive.function, at.square, at.height);
    return Region(
        Primitive{primitive.name,
                  function && function->is_even() ? function->even
                                                  : normalize_by_itself(parts->even, 3, length),
                  parts->even, primitive.selects_only},
        3);
  }
  if (parts && !off_axis && !primitive.selects_only)
    return squared_side(primitive.name, *parts, at, length);
  const std::vector<Field> map{sqrt(at.square), at.height};
  return Region(Primitive{primitive.name, compose(primitive.function, map),
                          compose(primitive.level, map), primitive.selects_only},
                3);
}

}  // namespace

Region extrusion(const Region& profile, double from, double to) {
  require_plane(profile);
  if (!(from < to)) throw InvalidArgument("an extrusion goes from a smaller to a larger z");
  const Field start = z_coordinate() - from, end = to - z_coordinate();
  const Region column =
      mapped_region(profile, [](const Primitive& primitive) { return Region(primitive, 3); });
  const Region body = column & side("start", start, start) & side("end", end, end);
  if (!profile.enclosure()) return body;
  const auto& [dimension, low, high] = *profile.enclosure();
  return body.within({3, {low[0], low[1], from}, {high[0], high[1], to}});
}

Region revolution(const Region& profile, const Point& center, const Point& axis) {
  require_plane(profile);
  const Meridian at = meridian(center, axis);
  const bool off_axis = keeps_off_axis(profile);
  const std::optional<Box>& known = profile.enclosure();
  const double size = known ? std::min(known->length(0), known->length(1)) : 1;
  const Region body = mapped_region(profile, [&](const Primitive& primitive) {
    MappedPrimitive turned = revolved(primitive, at, off_axis, size);
    if (primitive.joins_smoothly && turned.region) turned.region = joining_smoothly(*turned.region);
    return turned;
  });
  return profile.enclosure() ? body.within(turned_box(profile, center, axis)) : body;
}

}  // namespace rfm
