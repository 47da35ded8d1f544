#pragma once

#include <map>
#include <utility>
#include <vector>

#include "core/box.hpp"
#include "quadrature/facet.hpp"

namespace rfm {

/// A directed side of a triangle: the numbers of its vertices.
using Side = std::pair<int, int>;

template <class Visit>
void for_each_side(const std::vector<Facet>& facets, Visit&& visit) {
  for (const Facet& facet : facets)
    for (int i = 0; i < 3; ++i)
      visit(Side{facet.vertices[i], facet.vertices[(i + 1) % 3]}, facet.primitive);
}

/// Directed sides and how many more there are of them than of their opposites.
std::map<Side, int> open_sides(const std::vector<Facet>& facets);

/// The piece at each of some sides. Where a side is that of two pieces, the one is meant whose
/// opposite is missing.
std::map<Side, int> primitives_at(const std::map<Side, int>& sides,
                                  const std::vector<Facet>& facets);

/// Takes directed sides, with how often each is there, apart into loops that visit no vertex twice.
/// Where several sides leave a vertex the one that turns back most is taken: the two sides of a
/// crack are next to each other.
std::vector<std::vector<int>> side_loops(const std::map<Side, int>& sides,
                                         const std::vector<Point>& vertices);

}  // namespace rfm
