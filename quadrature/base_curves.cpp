// Curves of the base plane at a place of the outer axis: positions, slopes and bounds of slopes.

#include <algorithm>
#include <cmath>

#include "quadrature/reduction_3d.hpp"

namespace rfm {

Plane Reduction3D::section_plane(double outer_coordinate) const {
  Plane plane{box_, inner_, height_};
  plane.box.low[outer()] = plane.box.high[outer()] = outer_coordinate;
  return plane;
}

Reduction3D::CurvePoint Reduction3D::curve_point(const Curve& curve,
                                                 double outer_coordinate) const {
  return curve.is_crossing ? crossing_point(curve, outer_coordinate)
                           : trace_point(curve, outer_coordinate);
}

Reduction3D::CurvePoint Reduction3D::trace_point(const Curve& trace,
                                                 double outer_coordinate) const {
  const PlaneGraph graph = base_graph(trace);
  LineSegment line{{}, inner_, box_.low[inner_], box_.high[inner_]};
  line.through[outer()] = outer_coordinate;
  line.through[height_] = graph.third;
  const Crossing crossing = find_crossing(*graph.surface, line);
  Point gradient{};
  graph.surface->value_and_gradient(line.at(crossing.position), gradient);
  return {crossing.position, crossing.exists, -gradient[outer()] / gradient[inner_], graph.third};
}

// The inner coordinates at which a graph lies between bottom and top. Its traces are monotone, and
// it is a graph over the base: this is one interval, empty (low > high) if it is nowhere.
Interval Reduction3D::existence(int surface, double outer_coordinate) const {
  const double low = box_.low[inner_], high = box_.high[inner_];
  LineSegment line{{}, inner_, low, high};
  line.through[outer()] = outer_coordinate;
  std::array<Crossing, 2> ends;
  for (int end = 0; end < 2; ++end) {
    const Truth sign = end_signs_[surface][end];
    if (sign != Truth::unknown) {
      ends[end].starts_positive = sign == Truth::yes;
      continue;
    }
    line.through[height_] = end == 0 ? box_.low[height_] : box_.high[height_];
    ends[end] = find_crossing(*active_->surfaces[surface], line);
  }
  const auto& [bottom, top] = ends;
  const bool at_low = bottom.starts_positive != top.starts_positive;
  Interval where(low, high);
  if (bottom.exists && top.exists)
    return {std::min(bottom.position, top.position), std::max(bottom.position, top.position)};
  if (bottom.exists || top.exists)
    (at_low ? where.high : where.low) = bottom.exists ? bottom.position : top.position;
  else if (!at_low)
    where = {high, low};
  return where;
}

Reduction3D::CurvePoint Reduction3D::crossing_point(const Curve& crossing,
                                                    double outer_coordinate) const {
  const Plane plane = section_plane(outer_coordinate);
  const int i = crossing.first, j = crossing.second;
  const PlaneGraph p = section_graph(i, outer_coordinate), q = section_graph(j, outer_coordinate);
  const Interval of_p = existence(i, outer_coordinate), of_q = existence(j, outer_coordinate);
  const double low = std::max(of_p.low, of_q.low), high = std::min(of_p.high, of_q.high);
  CurvePoint point;
  const auto difference = [&](double place, double& slope) {
    return height_difference(plane, p, q, place, slope);
  };
  double slope = 0;
  if (!(low < high)) {
    point.position = std::clamp(0.5 * (low + high), box_.low[inner_], box_.high[inner_]);
  } else {
    const double at_low = difference(low, slope), at_high = difference(high, slope);
    point.exists = (at_low >= 0) != (at_high >= 0);
    point.position = point.exists ? bracketed_root(difference, low, high, at_low, at_high)
                     : std::fabs(at_low) < std::fabs(at_high) ? low
                                                              : high;
  }
  const LineSegment line = height_line(plane, p, point.position);
  point.height = find_crossing(*p.surface, line).position;
  Point a{}, b{};
  p.surface->value_and_gradient(line.at(point.height), a);
  q.surface->value_and_gradient(line.at(point.height), b);
  point.slope = -(a[outer()] * b[height_] - b[outer()] * a[height_]) /
                (a[inner_] * b[height_] - b[inner_] * a[height_]);
  return point;
}

// From the part of the box in which the curve can be: its place in the middle of the interval, give
// or take its slope.
Interval Reduction3D::slope_bounds(const Curve& curve, double from, double to) const {
  if (from == box_.low[outer()] && to == box_.high[outer()]) return curve.slope;
  const CurvePoint middle = curve_point(curve, 0.5 * (from + to));
  const double radius = 0.5 * (to - from);
  Box narrow = box_;
  narrow.low[outer()] = from;
  narrow.high[outer()] = to;
  const auto restrict_to = [&](int axis, double center, double reach) {
    narrow.low[axis] = std::max(narrow.low[axis], center - reach);
    narrow.high[axis] = std::min(narrow.high[axis], center + reach);
    if (!(narrow.low[axis] <= narrow.high[axis])) narrow.low[axis] = narrow.high[axis] = center;
  };
  const double reach = curve.slope.magnitude() * radius;
  restrict_to(inner_, middle.position, reach);
  std::array<std::array<Interval, maximum_variables>, 2> gradients;
  if (curve.is_crossing) {
    const auto& g = narrow_[curve.first].gradient;
    restrict_to(height_, middle.height,
                (g[outer()] / g[height_]).magnitude() * radius +
                    (g[inner_] / g[height_]).magnitude() * reach);
    gradients[0] = active_->surfaces[curve.first]->bounds(narrow).gradient;
    gradients[1] = active_->surfaces[curve.second]->bounds(narrow).gradient;
  } else {
    narrow.low[height_] = narrow.high[height_] = middle.height;
    gradients[0] = active_->surfaces[curve.first]->bounds(narrow).gradient;
    return intersection(-(gradients[0][outer()] / gradients[0][inner_]), curve.slope);
  }
  const auto &a = gradients[0], &b = gradients[1];
  const auto minor = [&](int axis) { return b[axis] * a[height_] - b[height_] * a[axis]; };
  return intersection(-(minor(outer()) / minor(inner_)), curve.slope);
}

}  // namespace rfm
