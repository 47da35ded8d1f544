#pragma once

#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "core/box.hpp"

namespace rfm {

/// One closed contour of a shape as points in order, either way round; the last point is joined to
/// the first, which may be repeated at the end. Its edges are called names[i] or, without names,
/// `prefix`edge1, `prefix`edge2, …: edge i starts at point i.
struct Contour {
  std::vector<Point> points;
  std::string prefix = {};
  std::vector<std::string> names = {};

  std::string name(int edge) const {
    return names.empty() ? prefix + "edge" + std::to_string(edge + 1) : names[edge];
  }
};

/// A contour without edges of length zero, counter-clockwise.
struct CleanContour {
  std::vector<Point> points;
  /// edges[i] is the number, from 0, of the edge of the original contour that joins points[i] and
  /// points[i + 1], one of them first.
  std::vector<int> edges;
  /// Whether the original went clockwise: then edges are walked backwards.
  bool reversed = false;
};

/// Consecutive points that are equal are merged, and the direction is made counter-clockwise by the
/// sign of the area. Throws `InvalidArgument` for coordinates that are not finite, fewer than three
/// different points, or no area.
CleanContour cleaned(const Contour& contour);

/// Twice the signed area, positive for counter-clockwise.
double twice_area(std::span<const Point> points);

struct Segment {
  Point from, to;
};

/// Two segments that have a point in common, other than the end of one from which the next one in
/// the list of its contour starts; nothing if there are none. `next[i]` is the segment that follows
/// segment i. Exact. A sweep along x: O(n log n) plus pairs whose boxes overlap.
std::optional<std::pair<int, int>> intersecting_pair(std::span<const Segment> segments,
                                                     std::span<const int> next);

/// Whether a point lies inside a closed polygon by the number of times the polygon winds around it:
/// exact; on the boundary either.
bool winds_around(std::span<const Point> polygon, const Point& point);

}  // namespace rfm
