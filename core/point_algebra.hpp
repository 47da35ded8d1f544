#pragma once

#include <cmath>

#include "core/box.hpp"

namespace rfm {

inline double dot(const Point& a, const Point& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
inline Point cross(const Point& a, const Point& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
inline double norm(const Point& a) { return std::sqrt(dot(a, a)); }
/// a − b.
inline Point difference(const Point& a, const Point& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
/// a / |a|, no number for a = 0.
inline Point unit(const Point& a) {
  const double size = norm(a);
  return {a[0] / size, a[1] / size, a[2] / size};
}
/// a + t b.
inline Point along(const Point& a, double t, const Point& b) {
  return {a[0] + t * b[0], a[1] + t * b[1], a[2] + t * b[2]};
}
inline Point scaled(double t, const Point& a) { return {t * a[0], t * a[1], t * a[2]}; }

}  // namespace rfm
