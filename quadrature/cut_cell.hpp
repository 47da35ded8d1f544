#pragma once

#include "quadrature/cell_moments.hpp"
#include "quadrature/gauss_legendre.hpp"
#include "quadrature/line_record.hpp"
#include "quadrature/quadrature_points.hpp"
#include "quadrature/subdivision.hpp"

namespace rfm {

struct CellRuleOptions {
  /// Gauss points per one-dimensional piece.
  int points = 6;
  /// Whether volume and boundary are also found by the rule of one point fewer (one more, if there
  /// is one): a fifth to a half of the cost again.
  bool compare_orders = true;
  /// Gauss points per axis of boxes within the cell that are inside: nothing is bent there, and
  /// what serves cells inside serves smaller boxes.
  int inside_points = 4;
  /// The part of the budget of a cell that is for this box.
  double share = 1;
};

/// What a cut cell contributes to a rule.
struct CellRule {
  VolumePoints volume;
  SurfacePoints boundary;
  SurfacePoints interfaces;
  Uncertified uncertified;
  /// Sums over boxes of how far the rules of two orders are apart: in the measure, or in one of the
  /// first moments where that is more. Errors of two orders may be the same by chance where they
  /// change their signs, but not those of all moments. (No moments with two points: one point
  /// is not exact for them even in boxes.)
  CellMeasure order_difference;
  /// Of the last box, by both rules.
  CellMoments moments, other_moments;
  /// Memory for the lines of a part and for the intervals they stand on, used again.
  LineRecord lines;
  SmoothIntervals intervals;
  /// The whole box is inside and nothing splits it.
  bool is_full = false;
};

/// Calls `add(Point, weight)` for the tensor product of `gauss` over a box, x running fastest.
template <class Add>
void add_tensor_rule(const Box& box, const GaussRule& gauss, Add&& add) {
  std::array<int, 3> size{1, 1, 1};
  for (int axis = 0; axis < box.dimension; ++axis) size[axis] = gauss.size();
  for (int k = 0; k < size[2]; ++k)
    for (int j = 0; j < size[1]; ++j)
      for (int i = 0; i < size[0]; ++i) {
        const std::array<int, 3> index{i, j, k};
        Point point{};
        double weight = 1;
        for (int axis = 0; axis < box.dimension; ++axis) {
          point[axis] = box.low[axis] + box.length(axis) * gauss.nodes[index[axis]];
          weight *= box.length(axis) * gauss.weights[index[axis]];
        }
        add(point, weight);
      }
}

/// Appends to `rule` the rules for ∫ over box ∩ region, over the boundary of the region in the box,
/// and over the interfaces inside, by iterated Gauss rules on the parts of a `Subdivision`. Weights
/// are positive. Errors are
/// O(h^(2·points)) for cells of size h, also with corners in cells, wherever primitives are smooth;
/// a boundary point carries its outward unit normal and primitive. Along a curve of slope h′ over
/// the base axis the weight is √(1 + |∇h|²) times the base weight, written |∇w| / |∂w/∂height|.
void add_cell_rule(const Box& box, const ActiveSet& active, const CellRuleOptions& options,
                   Subdivision& subdivision, CellRule& rule);

}  // namespace rfm
