#include "core/contour.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/error.hpp"
#include "core/orientation.hpp"

namespace rfm {
namespace {

bool is_between(const Point& a, const Point& b, const Point& c) {
  return std::min(a[0], b[0]) <= c[0] && c[0] <= std::max(a[0], b[0]) &&
         std::min(a[1], b[1]) <= c[1] && c[1] <= std::max(a[1], b[1]);
}

bool share_a_point(const Segment& p, const Segment& q) {
  const int a = orientation(p.from, p.to, q.from), b = orientation(p.from, p.to, q.to);
  const int c = orientation(q.from, q.to, p.from), d = orientation(q.from, q.to, p.to);
  if (a * b < 0 && c * d < 0) return true;
  return (a == 0 && is_between(p.from, p.to, q.from)) ||
         (b == 0 && is_between(p.from, p.to, q.to)) ||
         (c == 0 && is_between(q.from, q.to, p.from)) || (d == 0 && is_between(q.from, q.to, p.to));
}

// Whether `second`, which starts where `first` ends, turns back onto it.
bool turns_back(const Segment& first, const Segment& second) {
  if (orientation(first.from, first.to, second.to) != 0) return false;
  const double along = (first.to[0] - first.from[0]) * (second.to[0] - second.from[0]) +
                       (first.to[1] - first.from[1]) * (second.to[1] - second.from[1]);
  return along < 0;
}

}  // namespace

double twice_area(std::span<const Point> points) {
  double sum = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Point &p = points[i], &q = points[(i + 1) % points.size()], &o = points[0];
    sum += (p[0] - o[0]) * (q[1] - o[1]) - (p[1] - o[1]) * (q[0] - o[0]);
  }
  return sum;
}

CleanContour cleaned(const Contour& contour) {
  CleanContour result;
  const auto count = contour.points.size();
  for (std::size_t i = 0; i < count; ++i) {
    const Point& point = contour.points[i];
    if (!std::isfinite(point[0]) || !std::isfinite(point[1]))
      throw InvalidArgument("point " + std::to_string(i + 1) + " is not finite");
    if (point == contour.points[(i + 1) % count]) continue;
    result.points.push_back(point);
    result.edges.push_back(static_cast<int>(i));
  }
  if (result.points.size() < 3)
    throw InvalidArgument("a polygon needs at least three different points, got " +
                          std::to_string(result.points.size()));
  const double area = twice_area(result.points);
  // Points that are not on a line and have no area cross themselves, as a bow tie does: whoever
  // asks for crossings names the edges.
  const auto on_a_line = [&](const Point& point) {
    return orientation(result.points[0], result.points[1], point) == 0;
  };
  if (area == 0 && std::ranges::all_of(result.points, on_a_line))
    throw InvalidArgument("the polygon has no area");
  if (area >= 0) return result;
  // Backwards, the edge after point i is the one that led to it.
  result.reversed = true;
  std::ranges::reverse(result.points);
  std::ranges::reverse(result.edges);
  std::ranges::rotate(result.edges, result.edges.begin() + 1);
  return result;
}

std::optional<std::pair<int, int>> intersecting_pair(std::span<const Segment> segments,
                                                     std::span<const int> next) {
  const auto low = [&](int i, int axis) {
    return std::min(segments[i].from[axis], segments[i].to[axis]);
  };
  const auto high = [&](int i, int axis) {
    return std::max(segments[i].from[axis], segments[i].to[axis]);
  };
  std::vector<int> order(segments.size());
  std::iota(order.begin(), order.end(), 0);
  std::ranges::sort(order, {}, [&](int i) { return low(i, 0); });
  std::vector<int> active;
  for (const int i : order) {
    std::erase_if(active, [&](int j) { return high(j, 0) < low(i, 0); });
    for (const int j : active) {
      if (high(j, 1) < low(i, 1) || high(i, 1) < low(j, 1)) continue;
      const bool follows = next[j] == i, precedes = next[i] == j;
      const bool meet = follows    ? turns_back(segments[j], segments[i])
                        : precedes ? turns_back(segments[i], segments[j])
                                   : share_a_point(segments[i], segments[j]);
      if (meet) return std::pair(std::min(i, j), std::max(i, j));
    }
    active.push_back(i);
  }
  return std::nullopt;
}

bool winds_around(std::span<const Point> polygon, const Point& point) {
  int winding = 0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Point &p = polygon[i], &q = polygon[(i + 1) % polygon.size()];
    if (p[1] <= point[1] && q[1] > point[1] && orientation(p, q, point) > 0) ++winding;
    if (p[1] > point[1] && q[1] <= point[1] && orientation(p, q, point) < 0) --winding;
  }
  return winding != 0;
}

}  // namespace rfm
