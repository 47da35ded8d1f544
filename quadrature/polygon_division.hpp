#pragma once

#include <vector>

#include "core/box.hpp"
#include "quadrature/facet.hpp"

namespace rfm {

/// Divides a polygon into the triangles of least total length of sides and appends them to
/// `facets` as parts of `primitive`. No triangle has all its corners on one side of the triangle
/// that the polygon was: `sides[i]` has bit k set where corner i lies on its side k = 0, 1, 2; all
/// are 0 for other polygons. The time is cubic in the number of corners.
void divide_polygon(const std::vector<int>& polygon, const std::vector<unsigned>& sides,
                    const std::vector<Point>& vertices, int primitive, std::vector<Facet>& facets);

}  // namespace rfm
