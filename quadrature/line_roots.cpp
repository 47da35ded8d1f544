#include "quadrature/line_roots.hpp"

#include <cmath>

#include "quadrature/root_isolation.hpp"

namespace rfm {

Crossing find_crossing(const Surface& surface, const LineSegment& line) {
  Point point = line.at(line.low);
  const double value_low = surface.value(point);
  point[line.axis] = line.high;
  const double value_high = surface.value(point);
  Crossing crossing;
  crossing.starts_positive = value_low >= 0;
  crossing.exists = crossing.starts_positive != (value_high >= 0);
  if (!crossing.exists) {
    crossing.position = std::fabs(value_low) < std::fabs(value_high) ? line.low : line.high;
    return crossing;
  }
  const auto along = [&](double t, double& slope) {
    point[line.axis] = t;
    return surface.value_and_slope(point, line.axis, slope);
  };
  crossing.position = bracketed_root(along, line.low, line.high, value_low, value_high);
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
    const Crossing crossing = find_crossing(*active.surfaces[surface], line);
    if (crossing.starts_positive) roots.start |= 1u << surface;
    if (!crossing.exists) continue;
    int place = roots.count++;
    for (; place > 0 && roots.positions[place - 1] > crossing.position; --place) {
      roots.positions[place] = roots.positions[place - 1];
      roots.surfaces[place] = roots.surfaces[place - 1];
    }
    roots.positions[place] = crossing.position;
    roots.surfaces[place] = surface;
  }
  return roots;
}

}  // namespace rfm
