#include "core/line_groups.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace rfm {
namespace {

constexpr double coincidence = 1e-13;

double length(const Segment& s) { return std::hypot(s.to[0] - s.from[0], s.to[1] - s.from[1]); }

double distance_from(const Segment& line, const Point& point) {
  const double dx = line.to[0] - line.from[0], dy = line.to[1] - line.from[1];
  return std::fabs(dx * (point[1] - line.from[1]) - dy * (point[0] - line.from[0])) / length(line);
}

double along(const Segment& line, const Point& point) {
  return (line.to[0] - line.from[0]) * (point[0] - line.from[0]) +
         (line.to[1] - line.from[1]) * (point[1] - line.from[1]);
}

// The line from the first to the last end of both.
Segment spanned(const Segment& line, const Segment& other) {
  Segment result = line;
  for (const Point& end : {other.from, other.to}) {
    if (along(line, end) < along(line, result.from)) result.from = end;
    if (along(line, end) > along(line, result.to)) result.to = end;
  }
  return result;
}

}  // namespace

LineGroups group_by_line(std::span<const Segment> segments) {
  const int count = static_cast<int>(segments.size());
  double size = 0;
  Point low = segments[0].from, high = low;
  for (const Segment& s : segments)
    for (const Point& end : {s.from, s.to})
      for (int axis = 0; axis < 2; ++axis) {
        low[axis] = std::min(low[axis], end[axis]);
        high[axis] = std::max(high[axis], end[axis]);
        size = std::max({size, high[axis] - low[axis], 1e-3 * std::fabs(end[axis])});
      }
  const double tolerance = coincidence * size;
  // Candidates are neighbours in direction; long segments come first, as their direction is known
  // best.
  std::vector<double> angles;
  for (const Segment& s : segments)
    angles.push_back(std::atan2(s.to[1] - s.from[1], s.to[0] - s.from[0]));
  std::vector<int> by_length(count), by_angle(count);
  std::iota(by_length.begin(), by_length.end(), 0);
  by_angle = by_length;
  std::ranges::stable_sort(by_length, std::greater{}, [&](int i) { return length(segments[i]); });
  std::ranges::sort(by_angle, {}, [&](int i) { return angles[i]; });
  std::vector<int> rank(count);
  for (int i = 0; i < count; ++i) rank[by_angle[i]] = i;

  LineGroups result;
  result.group.assign(count, -1);
  for (const int i : by_length) {
    if (result.group[i] >= 0) continue;
    const int number = static_cast<int>(result.members.size());
    result.group[i] = number;
    result.members.push_back({i});
    result.lines.push_back(segments[i]);
    Segment& line = result.lines.back();
    const auto consider = [&](int j) {
      if (result.group[j] >= 0 || distance_from(line, segments[j].from) > tolerance ||
          distance_from(line, segments[j].to) > tolerance)
        return;
      result.group[j] = number;
      result.members.back().push_back(j);
      line = spanned(line, segments[j]);
    };
    // A segment of length l within the tolerance of a line turns from it by 2 tolerance / l.
    const double shortest = length(segments[by_length.back()]);
    const double angle = std::max(1e-9, std::min(0.1, 4 * tolerance / shortest));
    const auto nearby = [&](int j) {
      const double turn = std::remainder(angles[j] - angles[i], 2 * std::acos(-1.0));
      return std::fabs(turn) <= angle;
    };
    for (const int step : {1, -1})
      for (int k = 1; k < count; ++k) {
        const int j = by_angle[((rank[i] + step * k) % count + count) % count];
        if (!nearby(j)) break;
        consider(j);
      }
    std::ranges::sort(result.members.back());
  }
  return result;
}

}  // namespace rfm
