#include "quadrature/line_roots.hpp"

#include <algorithm>
#include <cmath>

#include "quadrature/root_clusters.hpp"
#include "quadrature/root_isolation.hpp"

namespace rfm {
namespace {

// Whether the square of a slope leaves the range of doubles.
bool is_extreme(double slope) {
  constexpr double least = 1e-140, most = 1e140;
  const double size = std::fabs(slope);
  return (size < least || size > most) && size > 0 && std::isfinite(size);
}

// The root near zero of c + b s + a s². Where the parabola is nearly straight it is a continued
// fraction with one division instead of a root between two, to a relative error of (ac/b²)⁴: half
// of the time of a step.
double near_root(double c, double b, double a) {
  constexpr double nearly_straight = 0.04;
  if (is_extreme(b)) return near_root(c / std::fabs(b), std::copysign(1, b), a / std::fabs(b));
  const double bb = b * b, ac = a * c;
  if (std::fabs(ac) <= nearly_straight * bb)
    return -c * b * (bb - 2 * ac) / (bb * (bb - 3 * ac) + ac * ac);
  const double root = std::sqrt(std::max(bb - 4 * ac, 0.0));
  return -2 * c / (b + std::copysign(root, b));
}

// The root of c + b s + a s² between 0 and `length`, where its sign changes once. Of the two roots
// the nearer one, 2|c| / (|b| + √(b² − 4ac)), if the polynomial starts towards zero, and the
// farther one otherwise: no difference of nearly equal numbers is taken.
double quadratic_root(double c, double b, double a, double length) {
  if (const double size = std::fabs(b) + std::fabs(a) * length; is_extreme(size))
    return quadratic_root(c / size, b / size, a / size, length);
  const double root = std::sqrt(std::max(b * b - 4 * a * c, 0.0));
  const bool towards_zero = (c >= 0) != (b > 0);
  const double step = towards_zero ? 2 * std::fabs(c) / (std::fabs(b) + root)
                                   : 0.5 * (std::fabs(b) + root) / std::fabs(a);
  // Also where the quotient is not a number.
  return step > 0 ? std::min(step, length) : 0.0;
}

struct Ends {
  double value_low, slope_low, value_high;
};

// The root of a surface on a segment from a start nearby: each step solves the parabola of value,
// slope and the curvature found from the last two slopes. After a step d the error is of order d³,
// so that most roots take two. Zeros of several or of no derivatives take many, which is work of
// its own.
double polished_root(const Surface& surface, const LineSegment& line, const Ends& ends,
                     double start) {
  constexpr int max_steps = 6;
  constexpr double last_step = 3e-6;
  const double length = line.high - line.low;
  Point point = line.through;
  int evaluations = 0;
  const auto along = [&](double t, double& slope) {
    constexpr int paid = 4, per_crossing = 4;
    if (++evaluations > paid)
      work_done += (surface.cost().crossing + per_crossing - 1) / per_crossing;
    point[line.axis] = t;
    return surface.value_and_slope(point, line.axis, slope);
  };
  double t = start, before = line.low, slope_before = ends.slope_low;
  for (int step = 0; step < max_steps && t > line.low && t < line.high; ++step) {
    double slope = 0;
    const double value = along(t, slope);
    if (value == 0) return t;
    const double change = near_root(value, slope, 0.5 * (slope - slope_before) / (t - before));
    if (std::fabs(change) < last_step * length) return std::clamp(t + change, line.low, line.high);
    before = t;
    slope_before = slope;
    t += change;
  }
  return bracketed_root(along, line.low, line.high, ends.value_low, ends.value_high);
}

// What the values at the ends of a segment tell; the position is that of an end.
Crossing between_ends(const LineSegment& line, double value_low, double value_high, Truth low,
                      Truth high) {
  Crossing crossing;
  crossing.starts_positive = low == Truth::unknown ? value_low >= 0 : low == Truth::yes;
  crossing.exists =
      crossing.starts_positive != (high == Truth::unknown ? value_high >= 0 : high == Truth::yes);
  constexpr double rounding = 1e-11;
  const double size_low = std::fabs(value_low), size_high = std::fabs(value_high);
  crossing.at_end = size_low <= rounding * size_high || size_high <= rounding * size_low;
  crossing.position = size_low < size_high ? line.low : line.high;
  return crossing;
}

}  // namespace

Crossing find_end_signs(const Surface& surface, const LineSegment& line, Truth low, Truth high) {
  work_done += surface.cost().crossing;
  return between_ends(line, surface.value(line.at(line.low)), surface.value(line.at(line.high)),
                      low, high);
}

Crossing find_crossing(const Surface& surface, const LineSegment& line, Truth low, Truth high) {
  work_done += surface.cost().crossing;
  Point point = line.at(line.low);
  double slope_low = 0;
  const double value_low = surface.value_and_slope(point, line.axis, slope_low);
  point[line.axis] = line.high;
  const double value_high = surface.value(point);
  Crossing crossing = between_ends(line, value_low, value_high, low, high);
  // Where the values do not show the crossing it is at an end.
  if (!crossing.exists || (value_low >= 0) == (value_high >= 0)) return crossing;
  const double length = line.high - line.low;
  const QuadricEvaluator* const quadric = surface.quadric();
  const double curve = quadric ? quadric->square[Quadric::square_index(line.axis, line.axis)]
                               : ((value_high - value_low) / length - slope_low) / length;
  if (quadric) {
    crossing.position = line.low + quadratic_root(value_low, slope_low, curve, length);
    return crossing;
  }
  const double step = near_root(value_low, slope_low, curve);
  // Also where it is not a number.
  const double start =
      line.low +
      (step > 0 && step < length ? step : quadratic_root(value_low, slope_low, curve, length));
  crossing.position = polished_root(surface, line, {value_low, slope_low, value_high}, start);
  return crossing;
}

LineRoots find_line_roots(const ActiveSet& active, SurfaceSigns parallel, const LineSegment& line) {
  LineRoots roots;
  for (int surface = 0; surface < active.count; ++surface) {
    if (parallel >> surface & 1) {
      if (active.surfaces[surface]->value(line.at(0.5 * (line.low + line.high))) >= 0)
        roots.start |= 1u << surface;
      continue;
    }
    const Crossing crossing = find_crossing(*active.surfaces[surface], line,
                                            line.ends[0].of(surface), line.ends[1].of(surface));
    if (crossing.starts_positive) roots.start |= 1u << surface;
    roots.at_end |= crossing.at_end;
    if (!crossing.exists) continue;
    int place = roots.count++;
    for (; place > 0 && roots.positions[place - 1] > crossing.position; --place) {
      roots.positions[place] = roots.positions[place - 1];
      roots.surfaces[place] = roots.surfaces[place - 1];
    }
    roots.positions[place] = crossing.position;
    roots.surfaces[place] = surface;
  }
  if (roots.count > 1) form_clusters(active, line, roots);
  return roots;
}

}  // namespace rfm
