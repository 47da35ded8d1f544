#pragma once

#include <array>
#include <vector>

#include "core/region.hpp"
#include "quadrature/truth_table.hpp"

namespace rfm {

/// How a region looks near a point to first order: primitives that vanish there become half-planes
/// (half-spaces) through the point, of the others only the sign counts.
struct LocalStructure {
  /// Numbers of the primitives that vanish, and their gradients.
  std::vector<int> primitives;
  std::vector<Point> gradients;
  /// Whether a sector is inside, by the signs of `primitives` (bit k set where k is ≥ 0).
  TruthTable inside;

  /// The structure of `region` at `point`, where `table` is the region as a function of the
  /// primitives `variables`. Primitives vanish that are zero within `distance`, to first order.
  LocalStructure(const RegionEvaluator& region, const TruthTable& table,
                 std::span<const int> variables, const Point& point, double distance);
  LocalStructure() = default;
};

/// A section of a region near a corner or an edge by a plane across it: sectors around a point.
struct SectorWalk {
  /// Sum of the angles of the sectors inside, 0 to 2π.
  double angle = 0;
  /// Directions, in the plane of the section, in which a piece of the boundary leaves.
  int rays = 0;
  /// The boundary is neither absent nor a straight line.
  bool is_corner = false;
};

/// Walks around a point whose vanishing primitives have the gradients (g·u, g·v) in the plane of
/// the orthonormal vectors u and v.
SectorWalk walk_sectors(const LocalStructure& structure, const Point& u, const Point& v);

/// A vertex of space to first order.
struct VertexStructure {
  /// Edges that leave it.
  int edges = 0;
  /// What the region takes of the unit sphere, 0 to 4π.
  double solid_angle = 0;
  /// Edges meet; a straight edge that passes is no vertex.
  bool is_vertex = false;
};

VertexStructure vertex_structure(const LocalStructure& structure);

/// Orthonormal vectors across `direction`, right-handed with it.
std::array<Point, 2> plane_across(const Point& direction);

}  // namespace rfm
