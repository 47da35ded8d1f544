#pragma once

#include "core/mesh_distance.hpp"
#include "core/part_ends.hpp"
#include "core/thin_set.hpp"

namespace rfm {

/// The closed set of points within a distance D of another set, as a part of boundaries.
struct Neighbourhood {
  /// D² − d², d the distance: ≥ 0 in the neighbourhood. Not smooth where several points of the set
  /// are nearest.
  Field where;
  /// Its boundary, D from corners, edges and faces, lies on spheres, cylinders and planes (in the
  /// plane on circles and lines): quadrics, which touch where one takes over from another.
  PartEnds ends;
};

/// Of triangles in space. Edges and corners within a flat part have no ends of their own. Those of
/// a feature (corner, edge, face) are left out in boxes that lie within D of the set or beyond, in
/// which another feature is nearer throughout, or where no point has its foot on the feature.
/// Throws `InvalidArgument` without triangles, or unless distance > 0.
Neighbourhood neighbourhood(const std::vector<Triangle>& triangles, double distance);

/// Of points, segments, arcs, triangles, and what is made of them; of a level curve only if it is
/// all of a line or a circle (a plane or a sphere in space): throws `InvalidArgument` for others,
/// and as above.
Neighbourhood neighbourhood(const ThinSet& set, double distance);

}  // namespace rfm
