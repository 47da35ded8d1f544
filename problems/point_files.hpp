#pragma once

#include <string>
#include <vector>

#include "core/box.hpp"

namespace rfm {

/// A list of points, each with the bulge of the arc to the next one (0: straight).
struct PointList {
  std::vector<Point> points;
  std::vector<double> bulges;
  /// A polyline of a drawing that is not flagged as closed.
  bool is_open = false;
  int line = 0;  ///< of a drawing, where it begins
};

/// Reads lists of points of the plane, as text of either kind:
/// - two or three columns x, y, bulge, separated by commas, semicolons (not both) or blanks; empty
/// lines
///   separate lists, lines that begin with `#` and one line of titles are passed over;
/// - DXF: the polylines and circles of a drawing, see `outlines_of_drawing`.
/// `name` stands in messages. Throws `InputError` with the line: `part.csv:3: expected a number but
/// found 'abc'`.
std::vector<PointList> parse_points(const std::string& text, const std::string& name);

}  // namespace rfm
