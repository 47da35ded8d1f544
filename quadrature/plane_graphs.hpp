#pragma once

#include "quadrature/line_roots.hpp"
#include "quadrature/root_contact.hpp"
#include "quadrature/root_isolation.hpp"

namespace rfm {

/// A rectangle spanned by a base axis and a height axis. In 3D the third coordinate is `box.low` of
/// the remaining axis, or another constant for single graphs.
struct Plane {
  Box box;
  int base = 0;
  int height = 1;

  int third() const { return 3 - base - height; }
  /// Of what a place in it is known to, in doubles.
  double rounding() const;
  double base_length() const { return box.length(base); }
  double height_length() const { return box.length(height); }
};

/// A surface cut by the plane with the given third coordinate: in the rectangle, a graph over the
/// base axis (or vertical: independent of the height). `bounds` enclose it over the rectangle.
struct PlaneGraph {
  const Surface* surface = nullptr;
  const FunctionBounds* bounds = nullptr;
  double third = 0;

  bool is_vertical(const Plane& plane) const { return bounds->gradient[plane.height].is_zero(); }
};

/// The segment of the height direction over a place of the base axis.
LineSegment height_line(const Plane& plane, const PlaneGraph& graph, double place);

/// Whether two graphs have different heights everywhere, by the mean value form of the difference
/// of heights, in which parallel slopes cancel.
bool proven_apart(const Plane& plane, const PlaneGraph& first, const PlaneGraph& second);

/// Base coordinates where the graph has the height `level`, appended to `found`. False if not all
/// could be isolated.
bool isolate_level(const Plane& plane, const PlaneGraph& graph, double level,
                   std::vector<double>& found);

/// Difference of the heights of two graphs at a place of the base axis; `slope` is its derivative.
double height_difference(const Plane& plane, const PlaneGraph& first, const PlaneGraph& second,
                         double place, double& slope);

/// Base coordinates between `from` and `to` where the graphs cross, appended to `found`, and where
/// they only touch, appended to `contacts`; both graphs must exist there. Where they are one on a
/// part of the interval, its ends are among those found. False if not all could be isolated.
bool isolate_crossings(const Plane& plane, const PlaneGraph& first, const PlaneGraph& second,
                       double from, double to, std::vector<double>& found,
                       std::vector<double>& contacts);

}  // namespace rfm
