#pragma once

#include <vector>

#include "core/grid.hpp"
#include "core/region.hpp"

namespace rfm {

struct EdgeOptions {
  /// Gauss points on each part of an edge between sides of boxes and vertices.
  int points = 6;
  /// Parts of the box of the region along its longest side. An edge is divided further where it
  /// bends so much that no coordinate parametrises it.
  int cells = 32;
  /// A part is halved until rules with as many points and with two fewer agree to this part of the
  /// longest side; infinity leaves all parts whole. Small holes in large bodies need it.
  double tolerance = 1e-12;
};

/// Points on the edges of a body: the curves in which two pieces of its boundary meet at an angle.
struct EdgePoints {
  std::array<std::vector<double>, 3> coordinates;
  /// Unit tangents; their sense is that of ∇(first) × ∇(second).
  std::array<std::vector<double>, 3> tangents;
  /// Of length.
  std::vector<double> weights;
  /// The two primitives.
  std::vector<int> first, second;
  /// Interior angles in radians (dihedral): below π at a convex edge, above at a reentrant one.
  std::vector<double> angles;

  int size() const { return static_cast<int>(weights.size()); }
  Point point(int i) const;
  Point tangent(int i) const;
  /// Of all edges, or of those between two primitives.
  double length() const;
  double length(int primitive, int other) const;
};

struct EdgeReport {
  /// Boxes that may hold parts of edges that are missing or less exact, and the sum of their sides.
  int uncertified_boxes = 0;
  double uncertified_length = 0;
  /// Boxes in which two surfaces touch, as a fillet does its plane: they are taken to form no edge.
  int contact_boxes = 0;
  /// Sum over the parts of the difference in length to rules with two points fewer (one, if there
  /// are no more than two): above the error where parts are short for their bends.
  double order_difference = 0;
};

/// A rule for ∫ f ds over the edges of a body, and what it leaves open.
struct EdgeRule {
  EdgePoints points;
  EdgeReport report;
};

/// The edges of a body in `box` (that of the region). The box is divided; where the bounds of two
/// primitives prove that their common zeros form a graph over one coordinate, the ends of the graph
/// in the box and the third primitives on it are isolated with proof, and a Gauss rule is used on
/// each part between them: errors are O(h^(2·points)) for boxes of size h, weights positive. Boxes
/// are divided further where edges bend too much for a graph, as around a small hole. A part
/// belongs to an edge if the section across it has a corner. Throws `InvalidArgument` for a region
/// that is not in space, and for numbers out of range.
EdgeRule make_edge_rule(const RegionEvaluator& region, const Box& box,
                        const EdgeOptions& options = {});

}  // namespace rfm
