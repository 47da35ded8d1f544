#include "quadrature/flat_surface.hpp"

#include <cmath>

#include "quadrature/line_roots.hpp"

namespace rfm {
namespace {

// Whether the gradient may be that of a flat surface across an axis, and shows not already that it
// is.
bool may_be_flat(const Box& box, const FunctionBounds& bounds, int axis) {
  if (!bounds.smooth || !bounds.gradient[axis].excludes_zero()) return false;
  bool depends = false;
  for (int other = 0; other < box.dimension; ++other) {
    if (other == axis) continue;
    depends |= !bounds.gradient[other].is_zero();
    if (bounds.gradient[other].excludes_zero()) return false;
  }
  return depends;
}

Box section(const Box& box, int axis, double place) {
  Box result = box;
  result.low[axis] = result.high[axis] = place;
  return result;
}

// The sign of a surface on a side of the box that it follows: rounding alone, but what rounding
// says is the same for the box beyond. Unknown where it says different things.
Truth sign_on(const Box& side, const Surface& surface) {
  constexpr std::array places{0.0, 0.13, 0.5, 0.71, 1.0};
  int positive = 0, count = 0;
  for (const double u : places)
    for (const double v : places) {
      Point point{};
      for (int axis = 0, k = 0; axis < side.dimension; ++axis)
        point[axis] =
            side.low[axis] + (side.length(axis) > 0 ? side.length(axis) * (k++ == 0 ? u : v) : 0.0);
      positive += surface.value(point) >= 0;
      ++count;
    }
  return positive == count ? Truth::yes : positive == 0 ? Truth::no : Truth::unknown;
}

}  // namespace

std::optional<FlatSurface> find_flat_surface(const Box& box, const Surface& surface,
                                             const FunctionBounds& bounds) {
  for (int axis = 0; axis < box.dimension; ++axis) {
    if (!may_be_flat(box, bounds, axis)) continue;
    const Interval& slope = bounds.gradient[axis];
    const LineSegment line{box.center(), axis, box.low[axis], box.high[axis]};
    const double near = same_height(line);
    double place = find_crossing(surface, line).position;
    const FunctionBounds on_plane = surface.bounds(section(box, axis, place));
    if (!(on_plane.value.magnitude() <= near * slope.mignitude())) continue;
    const double direction = slope.low > 0 ? 1 : -1;
    bool is_sure = true;
    for (const double side : {line.low, line.high}) {
      if (std::fabs(place - side) > near) continue;
      const Truth sign = sign_on(section(box, axis, side), surface);
      is_sure = sign != Truth::unknown;
      Point middle = line.at(side);
      const bool positive = is_sure ? sign == Truth::yes : surface.value(middle) >= 0;
      place = positive ? side : std::nextafter(side, side + direction);
      break;
    }
    Point normal{};
    normal[axis] = direction;
    return FlatSurface{Surface(-direction * place, normal), is_sure};
  }
  return {};
}

}  // namespace rfm
