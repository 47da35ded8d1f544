#include "core/intersection.hpp"

#include <cmath>

#include "core/point_algebra.hpp"

namespace rfm {
namespace {

constexpr int most_steps = 50;

// The last step of a quadratically convergent iteration is rounding.
bool negligible(const Point& step, const Point& at) {
  return dot(step, step) <= 1e-30 * (1e-30 + dot(at, at));
}

}  // namespace

std::optional<Point> common_zero(const LevelFunction& f, const LevelFunction& g,
                                 const Point& start) {
  Point point = start;
  double previous = INFINITY;
  for (int i = 0; i < most_steps; ++i) {
    Point a, b;
    const double u = f.value_and_gradient(point, a), v = g.value_and_gradient(point, b);
    // The shortest step s with a·s = −u, b·s = −v is a combination of a and b.
    const double aa = dot(a, a), ab = dot(a, b), bb = dot(b, b);
    const double determinant = aa * bb - ab * ab;
    if (!(determinant > 1e-16 * aa * bb)) return {};
    const double p = (-u * bb + v * ab) / determinant, q = (-v * aa + u * ab) / determinant;
    Point step;
    for (int axis = 0; axis < 3; ++axis) {
      step[axis] = p * a[axis] + q * b[axis];
      point[axis] += step[axis];
    }
    const double length = std::sqrt(dot(step, step));
    if (!std::isfinite(length)) return {};
    if (negligible(step, point)) return point;
    // Rounding keeps steps from vanishing next to a zero; they stop shrinking there.
    if (length >= 0.5 * previous && length * length <= 1e-26 * dot(point, point)) return point;
    previous = length;
  }
  return {};
}

std::optional<Point> common_zero(const LevelFunction& f, const LevelFunction& g,
                                 const LevelFunction& h, const Point& start) {
  Point point = start;
  double previous = INFINITY;
  for (int i = 0; i < most_steps; ++i) {
    Point a, b, c;
    const double u = f.value_and_gradient(point, a), v = g.value_and_gradient(point, b),
                 w = h.value_and_gradient(point, c);
    const Point bc = cross(b, c), ca = cross(c, a), ab = cross(a, b);
    const double determinant = dot(a, bc);
    if (!(std::fabs(determinant) > 1e-8 * std::sqrt(dot(a, a) * dot(b, b) * dot(c, c)))) return {};
    Point step;
    for (int axis = 0; axis < 3; ++axis) {
      step[axis] = -(u * bc[axis] + v * ca[axis] + w * ab[axis]) / determinant;
      point[axis] += step[axis];
    }
    const double length = std::sqrt(dot(step, step));
    if (!std::isfinite(length)) return {};
    if (negligible(step, point)) return point;
    if (length >= 0.5 * previous && length * length <= 1e-26 * dot(point, point)) return point;
    previous = length;
  }
  return {};
}

std::optional<Point> nearest_zero(const LevelFunction& f, const Point& start) {
  Point point = start;
  double previous = INFINITY;
  for (int i = 0; i < most_steps; ++i) {
    Point gradient;
    const double value = f.value_and_gradient(point, gradient);
    const double square = dot(gradient, gradient);
    if (!(square > 0)) return value == 0 ? std::optional(point) : std::nullopt;  // on a kink
    Point step;
    for (int axis = 0; axis < 3; ++axis) {
      step[axis] = -value / square * gradient[axis];
      point[axis] += step[axis];
    }
    const double length = std::sqrt(dot(step, step));
    if (!std::isfinite(length)) return {};
    if (negligible(step, point)) return point;
    if (length >= 0.5 * previous && length * length <= 1e-26 * dot(point, point)) return point;
    previous = length;
  }
  return {};
}

std::optional<Point> double_zero(const LevelFunction& f, const Point& start) {
  Point point = start, gradient{};
  double value = f.value_and_gradient(point, gradient);
  const double first = norm(gradient);
  if (!(first > 0)) return value == 0 ? std::optional(point) : std::nullopt;
  double step = 2 * value / (first * first);
  for (int i = 0; i < most_steps; ++i) {
    if (value == 0) return point;
    if (norm(gradient) <= 1e-12 * first) {
      // An extreme; a zero if the value is as small as the distance from it squared.
      const bool zero = std::fabs(value) <= 1e-20 * first * norm(difference(start, point));
      return zero ? std::optional(point) : std::nullopt;
    }
    const Point moved = along(point, -step, gradient);
    Point next;
    value = f.value_and_gradient(moved, next);
    const Point way = difference(moved, point), change = difference(next, gradient);
    step = dot(way, way) / dot(way, change);
    if (!std::isfinite(step) || !std::isfinite(value)) return {};
    point = moved;
    gradient = next;
  }
  return {};
}

}  // namespace rfm
