#include "core/piece_points.hpp"

#include <algorithm>
#include <cmath>
#include <deque>

#include "core/intersection.hpp"
#include "core/point_algebra.hpp"

namespace rfm {
namespace {

// Fractions of a piece, none of them simple.
constexpr double fractions[] = {0.0173, 0.1327, 0.3119, 0.5237, 0.7351, 0.8713, 0.9811};

std::vector<Point> on_an_arc(const ThinSet& arc) {
  const Point &a = arc.points[0], &b = arc.points[1];
  std::vector<Point> points;
  if (arc.bulge == 0) {
    for (const double t : fractions) points.push_back(along(a, t, difference(b, a)));
    return points;
  }
  // The centre lies half the chord times (1 − b²)/(2b) to the left of its middle.
  const double shift = (1 - arc.bulge * arc.bulge) / (4 * arc.bulge);
  const Point center{0.5 * (a[0] + b[0]) - shift * (b[1] - a[1]),
                     0.5 * (a[1] + b[1]) + shift * (b[0] - a[0])};
  const Point start = difference(a, center);
  for (const double t : fractions) {
    const double turn = 4 * std::atan(arc.bulge) * t, c = std::cos(turn), s = std::sin(turn);
    points.push_back(
        {center[0] + c * start[0] - s * start[1], center[1] + s * start[0] + c * start[1]});
  }
  return points;
}

std::vector<Point> on_a_triangle(const ThinSet& triangle) {
  std::vector<Point> points;
  for (const double s : fractions)
    for (const double t : fractions) {
      const Point far =
          along(triangle.points[1], t, difference(triangle.points[2], triangle.points[1]));
      points.push_back(along(triangle.points[0], s, difference(far, triangle.points[0])));
    }
  return points;
}

std::vector<Point> found_in(const Box& bounds, const ThinSet& piece) {
  constexpr int most_boxes = 1000, enough = 20;
  const LevelFunction surface(*piece.surface, piece.dimension);
  const LevelFunction where(piece.where, piece.dimension);
  std::vector<Point> points;
  std::deque<Box> pending{bounds};
  for (int box_count = 0; box_count < most_boxes && !pending.empty(); ++box_count) {
    const Box box = pending.front();
    pending.pop_front();
    if (!surface.value_bounds(box).contains(0) || where.value_bounds(box).high < 0) continue;
    const std::optional<Point> zero = nearest_zero(surface, box.center());
    if (zero && box.contains(*zero) && where.value(*zero) > 0) {
      points.push_back(*zero);
      if (points.size() == enough) break;
    }
    for (const Box& half : bisect(box, box.longest_axis())) pending.push_back(half);
  }
  return points;
}

}  // namespace

std::vector<Point> points_on(const ThinSet& piece, const Box& bounds) {
  if (piece.dimension == 2 && piece.points.size() == 2) return on_an_arc(piece);
  if (piece.dimension == 3 && piece.points.size() == 3) return on_a_triangle(piece);
  return found_in(bounds, piece);
}

double extent_of(const std::vector<Point>& points) {
  double extent = 0;
  for (const Point& p : points)
    for (const Point& q : points)
      for (int axis = 0; axis < 3; ++axis) extent = std::max(extent, std::fabs(p[axis] - q[axis]));
  return extent;
}

}  // namespace rfm
