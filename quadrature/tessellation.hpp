#pragma once

#include "quadrature/cell_surfaces.hpp"

namespace rfm {

/// Shapes of elements, with the numbers and vertex orders of VTK.
enum class ElementShape : unsigned char {
  segment = 3,
  triangle = 5,
  quadrilateral = 9,
  tetrahedron = 10,
  hexahedron = 12
};

/// Elements of mixed shapes: element e has the vertices connectivity[begin[e]] … .
struct ElementList {
  std::vector<int> connectivity;
  std::vector<int> begin{0};
  std::vector<ElementShape> shapes;

  int size() const { return static_cast<int>(shapes.size()); }
  std::span<const int> vertices(int element) const {
    return std::span(connectivity)
        .subspan(begin[element], static_cast<std::size_t>(begin[element + 1] - begin[element]));
  }
  void add(ElementShape shape, std::span<const int> vertices);
  /// Appends other elements, their vertices renumbered from `first_vertex` on.
  void append(const ElementList& other, int first_vertex);
};

/// A region cut into elements, for pictures: elements do not overlap, corners of the region are
/// vertices, and every vertex of the boundary lies on its primitive up to rounding. Curved pieces
/// are followed by straight sides, so that areas and volumes converge with order 2 and those of
/// polygons and polyhedra are exact.
struct Tessellation {
  std::vector<Point> vertices;
  ElementList elements;
  /// The cell of the grid in which each element lies.
  std::vector<int> grid_cells;
  /// The boundary: in 2D segments with the inside on their left, in 3D triangles that are
  /// counter-clockwise seen from outside, in 1D none.
  ElementList boundary;
  /// The primitive of each boundary element.
  std::vector<int> primitives;
  Uncertified uncertified;
};

struct TessellationOptions {
  /// Elements per cell and axis.
  int subdivisions = 4;
  /// As for rules: elements lie on one side of these coordinates.
  Breakpoints breakpoints;
  SubdivisionOptions subdivision;
};

/// Takes the cells apart as the rules do, but visits equally spaced lines with both ends instead of
/// Gauss points. Vertices that several elements share within a cell part have one number; others
/// appear more than once (their coordinates are equal), and vertices may hang on sides of
/// neighbours. `interfaces` separate elements too. Throws `InvalidArgument` for fewer than one
/// subdivision or different dimensions.
Tessellation tessellate(const RegionEvaluator& region, const Grid& grid,
                        const TessellationOptions& options = {},
                        std::span<const LevelFunction> interfaces = {});

}  // namespace rfm
