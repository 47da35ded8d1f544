#pragma once

#include <span>
#include <vector>

#include "core/contour.hpp"

namespace rfm {

/// Directed segments that lie on one line in one direction, up to 10⁻¹³ of the size of the whole.
struct LineGroups {
  /// The group of each segment.
  std::vector<int> group;
  /// Per group: its segments, ascending, and the two of their ends that are farthest apart.
  std::vector<std::vector<int>> members;
  std::vector<Segment> lines;
};

LineGroups group_by_line(std::span<const Segment> segments);

}  // namespace rfm
