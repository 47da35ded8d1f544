#pragma once

#include <vector>

#include "core/box.hpp"
#include "quadrature/facet.hpp"

namespace rfm {

/// Closes the cracks between triangles whose sides follow the same curve from one common vertex to
/// another through different vertices in between. The sides that have no counterpart form thin
/// loops; the two ways around a loop, between its vertices farthest apart, are merged by arc
/// length, and the triangles on both sides are divided at the vertices they get. Vertices stay
/// where they are. Loops that are no cracks are filled if they are not larger than `largest_hole`;
/// others (a surface with a rim) remain.
std::vector<Facet> stitched(const std::vector<Facet>& facets, const std::vector<Point>& vertices,
                            double largest_hole);

/// The number of directed sides without one that runs the opposite way.
int count_open_sides(const std::vector<Facet>& facets);

}  // namespace rfm
