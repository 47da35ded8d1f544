#pragma once

#include <array>

#include "core/interval.hpp"

namespace rfm {

/// Coordinates (x, y, z); those beyond the dimension in use are zero.
using Point = std::array<double, 3>;

/// The axis-parallel box low ≤ x ≤ high in the first `dimension` coordinates.
struct Box {
  int dimension = 2;
  Point low{};
  Point high{};

  double length(int axis) const { return high[axis] - low[axis]; }
  double longest_side() const;
  int longest_axis() const;
  /// Length, area or volume.
  double measure() const;
  Point center() const;
  Interval interval(int axis) const { return {low[axis], high[axis]}; }
  bool contains(const Point& point) const;
};

/// The two halves of `box` across the middle of `axis`.
std::array<Box, 2> bisect(const Box& box, int axis);

}  // namespace rfm
