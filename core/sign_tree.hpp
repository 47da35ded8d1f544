#pragma once

#include <deque>
#include <vector>

#include "core/region.hpp"

namespace rfm {

/// The boxes of repeated bisection of the bounds of a region, with the signs that bounds prove of
/// its primitives. A box is looked at when a search first comes to it, by bounds of the primitives
/// that are undecided in the box it is half of, and then known to all later searches: of the n²/2
/// pairs of edges of a polygon only few meet, and each box costs its own few edges. Keeps the
/// region alive by reference only; not for several threads at once.
class SignTree {
 public:
  struct Node {
    Box box;
    std::vector<Truth> signs;  ///< yes: > 0 all over the box, no: < 0
    Truth inside;              ///< whether the box is in the region
    std::vector<int> undecided;
    int first_half = -1;  ///< the other one follows
    Truth of(int primitive) const { return signs[primitive]; }
    Truth of(const BooleanExpression& expression) const { return expression.evaluate(signs); }
  };

  /// Boxes go down to 2⁻¹⁰ of the bounds, in space to 2⁻⁶.
  SignTree(const RegionEvaluator& region, const Box& bounds);

  const RegionEvaluator& region() const { return region_; }
  const Box& bounds() const { return bounds_; }

  /// Visits the boxes that `is_undecided(node)` keeps; `leaf(box)` looks at the smallest of them
  /// and stops the search by returning false.
  template <class IsUndecided, class Leaf>
  void search(const IsUndecided& is_undecided, const Leaf& leaf) {
    std::vector<int> pending{0};
    while (!pending.empty()) {
      const int number = pending.back();
      pending.pop_back();
      if (!is_undecided(nodes_[number])) continue;
      if (nodes_[number].box.longest_side() <= smallest_) {
        if (!leaf(nodes_[number].box)) return;
        continue;
      }
      halve(number);
      pending.push_back(nodes_[number].first_half);
      pending.push_back(nodes_[number].first_half + 1);
    }
  }

 private:
  void add(const Box& box, const std::vector<Truth>& signs, const std::vector<int>& undecided);
  void halve(int number);

  const RegionEvaluator& region_;
  Box bounds_;
  double smallest_;
  std::deque<Node> nodes_;
};

}  // namespace rfm
