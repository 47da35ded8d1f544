#pragma once

#include <map>
#include <memory>
#include <vector>

#include "core/boolean.hpp"
#include "core/curve_division.hpp"
#include "core/curved_contour.hpp"
#include "core/line_groups.hpp"
#include "core/outline.hpp"

namespace rfm {

/// The primitives of a curved polygon and what its edges are called: half-planes of the chords, one
/// for chords on one line (a separator where no straight edge lies on it), and circles and conics
/// of curved edges, one for edges on one circle. `edges` and `contours` must outlive it.
class CurvedPolygonPrimitives {
 public:
  CurvedPolygonPrimitives(const std::vector<CurvedEdge>& edges,
                          const std::vector<std::vector<ContourLink>>& contours);

  /// The chords of all links, contour by contour: group g is primitive g.
  const LineGroups& lines() const { return lines_; }
  /// What stands for a link with this chord in the expression of its contour.
  BooleanExpression leaf(const ContourLink& link, const BooleanExpression& chord);
  /// Those that pass into each other smoothly are marked. To be called after `leaf` for all links,
  /// as `sides`.
  std::vector<std::shared_ptr<const Primitive>> primitives();
  /// Sides that are parts of a primitive, or made of several edges.
  std::vector<OutlineSide> sides() const;

 private:
  void add_groups(std::vector<OutlineSide>& sides) const;
  void mark_smooth_joints();
  void add_lines();
  bool holds_everything(int primitive) const;
  int curve(int number);

  const std::vector<CurvedEdge>& edges_;
  const std::vector<std::vector<ContourLink>>& contours_;
  LineGroups lines_;
  std::vector<Primitive> primitives_;
  std::map<int, int> curve_of_;   ///< of an edge, its primitive
  std::map<int, int> branch_of_;  ///< of a conic, the separator of its branches, or −1
};

}  // namespace rfm
