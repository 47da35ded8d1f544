#pragma once

#include "quadrature/gauss_legendre.hpp"
#include "quadrature/quadrature_points.hpp"
#include "quadrature/subdivision.hpp"

namespace rfm {

/// What a cut cell contributes to a rule.
struct CellRule {
  VolumePoints volume;
  SurfacePoints boundary;
  SurfacePoints interfaces;
  Uncertified uncertified;
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
/// and over the interfaces inside, with `points` Gauss points per one-dimensional piece: by
/// iterated Gauss rules on the parts of a `Subdivision`. Weights are positive. Errors are
/// O(h^(2·points)) for cells of size h, also with corners in cells, wherever primitives are smooth;
/// a boundary point carries its outward unit normal and primitive. Along a curve of slope h′ over
/// the base axis the weight is √(1 + |∇h|²) times the base weight, written |∇w| / |∂w/∂height|.
void add_cell_rule(const Box& box, const ActiveSet& active, int points, Subdivision& subdivision,
                   CellRule& rule);

}  // namespace rfm
