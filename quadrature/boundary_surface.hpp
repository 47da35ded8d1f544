#pragma once

#include "quadrature/tessellation.hpp"

namespace rfm {

/// The boundary of a region as facets: segments in 2D with the region on their left, triangles in
/// 3D that are counter-clockwise seen from outside. Every point lies on its primitive, so that
/// lengths and areas converge with order 2 and are exact for polygons and polyhedra. Pieces do not
/// share points, so that data jump at sharp edges.
struct BoundarySurface {
  std::vector<Point> points;
  /// Outward unit normals of the primitive at the points; that of a facet where the gradient
  /// vanishes.
  std::vector<Point> normals;
  /// The primitive of each point.
  std::vector<int> primitives;
  ElementList facets;
  /// Edges (ends in 2D) that do not run equally often in both directions: holes that are left.
  int open_edges = 0;
};

/// Takes the facets of a tessellation. Points closer than 10⁻⁹ of its size are one. In 3D the
/// facets of neighbouring cells that meet along a curve in different points are given each other's
/// points, and divided, so that the surface closes.
BoundarySurface boundary_surface(const RegionEvaluator& region, const Tessellation& tessellation);

}  // namespace rfm
