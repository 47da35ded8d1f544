#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/circular_edge.hpp"

namespace rfm::test {

/// From a chain of lines and arcs, edge by edge.
inline double distance_from(const std::vector<CircularEdge>& chain, const Point& x) {
  double least = INFINITY;
  for (const CircularEdge& edge : chain) least = std::min(least, edge.distance(x));
  return least;
}

}  // namespace rfm::test
