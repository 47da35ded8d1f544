#include "core/mesh_distance.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/error.hpp"
#include "core/point_algebra.hpp"

namespace rfm {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

Point along(const Point& from, const Point& step, double t) {
  return {from[0] + t * step[0], from[1] + t * step[1], from[2] + t * step[2]};
}
double square_distance(const Point& a, const Point& b) {
  const Point d = difference(a, b);
  return dot(d, d);
}

TrianglePoint on_segment(const Point& a, const Point& b, const Point& point) {
  const Point step = difference(b, a);
  const double square = dot(step, step);
  const double t = square > 0 ? dot(difference(point, a), step) / square : 0.0;
  if (!(t > 0)) return {a, 0, {}};
  if (t >= 1) return {b, 0, {}};
  return {along(a, step, t), 1, {unit(step), Point{}}};
}

std::vector<Box> boxes_of(const std::vector<Triangle>& triangles) {
  if (triangles.empty()) throw InvalidArgument("a surface without triangles does not exist");
  std::vector<Box> boxes;
  for (const Triangle& triangle : triangles) {
    Box& box = boxes.emplace_back(3, triangle[0], triangle[0]);
    for (const Point& corner : triangle)
      for (int axis = 0; axis < 3; ++axis) {
        box.low[axis] = std::min(box.low[axis], corner[axis]);
        box.high[axis] = std::max(box.high[axis], corner[axis]);
      }
  }
  return boxes;
}

}  // namespace

TrianglePoint nearest_point(const Triangle& triangle, const Point& point) {
  const Point ab = difference(triangle[1], triangle[0]), ac = difference(triangle[2], triangle[0]);
  const Point normal = cross(ab, ac);
  const double area = dot(normal, normal);
  // The normal of a triangle that is a segment or a point is rounding.
  if (area > 1e-24 * dot(ab, ab) * dot(ac, ac)) {
    const Point ap = difference(point, triangle[0]);
    const double v = dot(cross(ap, ac), normal) / area, w = dot(cross(ab, ap), normal) / area;
    if (v >= 0 && w >= 0 && v + w <= 1) {
      const Point first = unit(ab);
      return {along(along(triangle[0], ab, v), ac, w), 2, {first, cross(unit(normal), first)}};
    }
  }
  TrianglePoint best = on_segment(triangle[0], triangle[1], point);
  for (int i = 1; i < 3; ++i) {
    const TrianglePoint other = on_segment(triangle[i], triangle[(i + 1) % 3], point);
    if (square_distance(other.nearest, point) < square_distance(best.nearest, point)) best = other;
  }
  return best;
}

MeshSquareDistance::MeshSquareDistance(std::vector<Triangle> triangles)
    : triangles_(std::move(triangles)), tree_(boxes_of(triangles_)) {}

int MeshSquareDistance::nearest_triangle(const Point& point) const {
  double best = infinite;
  int nearest = 0;
  tree_.walk(
      point,
      [&](int i) {
        const double square = square_distance(nearest_point(triangles_[i], point).nearest, point);
        if (square < best) best = square, nearest = i;
      },
      [&] { return best; });
  return nearest;
}

void MeshSquareDistance::evaluate(const std::array<const double*, 3>& coordinates, int count,
                                  int variables, int order, double* jets, int stride) const {
  const auto coefficient = [&](const MultiIndex& index, int i) -> double& {
    return jets[std::ptrdiff_t(jet_index(variables, index)) * stride + i];
  };
  for (int c = 0; c < jet_size(variables, order); ++c)
    std::fill_n(jets + std::ptrdiff_t(c) * stride, count, 0.0);
  const int own = std::min(variables, 3);
  for (int i = 0; i < count; ++i) {
    const Point point{coordinates[0][i], coordinates[1][i], coordinates[2][i]};
    const TrianglePoint foot = nearest_point(triangles_[nearest_triangle(point)], point);
    const Point offset = difference(point, foot.nearest);
    coefficient({}, i) = dot(offset, offset);
    for (int a = 0; a < own && order >= 1; ++a) {
      coefficient(unit_index(a), i) = 2 * offset[a];
      // 2 (I − projection on the directions), halved on its diagonal by the factor 1/α!.
      for (int b = 0; b <= a && order >= 2; ++b) {
        double entry = a == b ? 2 : 0;
        for (int k = 0; k < foot.directions; ++k)
          entry -= 2 * foot.direction[k][a] * foot.direction[k][b];
        coefficient(unit_index(a) + unit_index(b), i) = a == b ? 0.5 * entry : entry;
      }
    }
  }
}

FunctionBounds MeshSquareDistance::bounds(const Box& box) const {
  const Point center = box.center();
  Point radius{};
  for (int axis = 0; axis < 3; ++axis)
    radius[axis] = std::max(box.high[axis] - center[axis], center[axis] - box.low[axis]);
  const double reach = std::sqrt(dot(radius, radius)) * (1 + 1e-15);
  FunctionBounds bounds;
  if (!std::isfinite(reach)) {
    bounds.value = Interval(0, infinite);
    for (Interval& slope : bounds.gradient) slope = Interval::entire();
    bounds.smooth = false;
    return bounds;
  }
  const int nearest = nearest_triangle(center);
  const Point foot = nearest_point(triangles_[nearest], center).nearest;
  const double distance = std::sqrt(square_distance(center, foot));
  const double rounding = 1e-14 * (distance + reach + std::fabs(center[0]) + std::fabs(center[1]) +
                                   std::fabs(center[2]));
  // Above: that of one triangle, which is convex, at the corners.
  double high = 0, low = infinite;
  for (int corner = 0; corner < 8; ++corner) {
    Point at;
    for (int axis = 0; axis < 3; ++axis)
      at[axis] = (corner >> axis & 1) != 0 ? box.high[axis] : box.low[axis];
    high = std::max(high, square_distance(nearest_point(triangles_[nearest], at).nearest, at));
  }
  // Below: the tangents of all that may be the nearest somewhere in the box.
  std::array<Interval, 3> gradient;
  bool first = true;
  const double farthest = distance + 2 * reach + rounding;
  tree_.walk(
      center,
      [&](int i) {
        const Point p = nearest_point(triangles_[i], center).nearest;
        const Point offset = difference(center, p);
        const double square = dot(offset, offset);
        if (square > farthest * farthest) return;
        double tangent = square;
        for (int axis = 0; axis < 3; ++axis) {
          tangent -= 2 * std::fabs(offset[axis]) * radius[axis];
          const double spread = 2 * (reach + rounding);
          const Interval slope(2 * offset[axis] - spread, 2 * offset[axis] + spread);
          gradient[axis] = first ? slope : hull(gradient[axis], slope);
        }
        low = std::min(low, tangent);
        // Feet that lie farther apart than the box is wide are of different sheets: a kink.
        const double apart = 4 * reach + rounding;
        if (square_distance(p, foot) > apart * apart) bounds.smooth = false;
        first = false;
      },
      [&] { return farthest * farthest; });
  const double nearer = std::max(0.0, distance - reach - rounding);
  const double slack = rounding * (distance + reach);
  bounds.value = Interval(std::max({0.0, low - slack, nearer * nearer}), high + slack);
  std::copy(gradient.begin(), gradient.end(), bounds.gradient.begin());
  return bounds;
}

std::vector<double> MeshSquareDistance::breakpoints(int) const { return {}; }

Box MeshSquareDistance::valid() const {
  return {3, {-infinite, -infinite, -infinite}, {infinite, infinite, infinite}};
}

}  // namespace rfm
