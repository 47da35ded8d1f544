#pragma once

#include <cstdint>
#include <vector>

#include "core/line.hpp"
#include "core/region.hpp"
#include "quadrature/surface_candidates.hpp"

namespace rfm {

/// What is known of a region throughout a box: either the answer, or the primitives that matter
/// there and the region as a Boolean expression of their signs alone (variable i is `primitives[i]`
/// being ≥ 0).
struct RegionPart {
  Truth inside = Truth::unknown;
  std::vector<int> primitives;
  BooleanExpression expression = BooleanExpression::constant(false);
};

/// A box halved again and again across its longest side until the region is known in a part, or few
/// and simple primitives are left there: what a ray needs to skip the parts that it cannot hit.
/// Built on rigorous bounds over slightly enlarged boxes, so that the rounding of a ray's ends is
/// covered.
class RayTree {
 public:
  /// `max_depth` halvings at most.
  RayTree(const RegionEvaluator& region, const Box& bounds, int max_depth);

  using Gradient = std::array<Interval, maximum_variables>;

  const Box& bounds() const { return bounds_; }
  int part_count() const { return static_cast<int>(parts_.size()); }
  int node_count() const { return static_cast<int>(nodes_.size()); }

  /// Calls `visit(part, gradients, from, to)` for the parts that a line passes between the
  /// parameters `low` and `high`, in their order, which join without gaps, until it returns true.
  /// `gradients` are bounds of ∇level there, of each of the part's primitives that is no quadric.
  template <class Visit>
  void walk(const Line& line, double low, double high, Visit&& visit) const {
    struct Pending {
      int node;
      double low, high;
    };
    std::array<Pending, max_allowed_depth + 1> pending;
    int count = 0, node = 0;
    for (;;) {
      while (nodes_[node].axis >= 0) {
        const Node& branch = nodes_[node];
        const double direction = line.direction[branch.axis], from = line.origin[branch.axis];
        if (direction == 0) {
          node = from < branch.place ? branch.below : branch.below + 1;
          continue;
        }
        const double crossing = (branch.place - from) / direction;
        const int near = branch.below + (direction < 0), far = branch.below + (direction > 0);
        if (crossing <= low) {
          node = far;
        } else {
          node = near;
          if (crossing < high) {
            pending[count++] = {far, crossing, high};
            high = crossing;
          }
        }
      }
      const Node& leaf = nodes_[node];
      if (visit(parts_[leaf.below], gradients_.data() + leaf.gradients, low, high) || count == 0)
        return;
      --count;
      node = pending[count].node;
      low = pending[count].low;
      high = pending[count].high;
    }
  }

  static constexpr int max_allowed_depth = 48;

 private:
  struct Node {
    double place = 0;        ///< where the box is halved
    std::int32_t below = 0;  ///< the lower half, which the upper one follows; of a leaf its part
    std::int32_t axis = -1;  ///< −1: a leaf
    std::int32_t gradients = 0;  ///< of a leaf: where its bounds begin
  };
  class Builder;

  Box bounds_;
  std::vector<Node> nodes_;
  std::vector<RegionPart> parts_;
  std::vector<Gradient> gradients_;
};

}  // namespace rfm
