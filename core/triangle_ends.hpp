#pragma once

#include <vector>

#include "core/mesh_distance.hpp"
#include "core/part_ends.hpp"

namespace rfm {

/// The points at a distance from a surface of triangles, whose corners may coincide so that they
/// are segments or points: spheres, cylinders and planes (in the plane circles and lines), each
/// a function that is normalised where it is zero, and where each of them matters. Faces side by
/// side in a plane, and edges one after the other on a line, share their functions; edges and
/// corners within a flat part have none. In a box those of a feature (corner, edge, face) are left
/// out if it lies within the distance of the set or beyond, another feature is nearer throughout,
/// or no point has its foot on the feature. `distance` > 0; throws `InvalidArgument` without
/// triangles.
PartEnds ends_around(const std::vector<Triangle>& triangles, double distance, int dimension);

/// The sphere (in the plane the circle) of this radius about a point: positive inside.
Field end_around(const Point& corner, double distance, int dimension);

}  // namespace rfm
