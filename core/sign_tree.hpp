#pragma once

#include <deque>
#include <span>
#include <utility>
#include <vector>

#include "core/region.hpp"

namespace rfm {

/// The boxes of repeated bisection of the bounds of a region, with the signs that bounds prove of
/// its primitives. A box is looked at when a search first comes to it, by bounds of the primitives
/// that are undecided in the box it is half of, and then known to all later searches: of the n²/2
/// pairs of edges of a polygon only few meet, and each box costs its own few edges. Keeps the
/// region alive by reference only; not for several threads at once, and no search within another.
class SignTree {
 public:
  /// A box as a search sees it.
  struct Node {
    const Box& box;
    std::span<const Truth> signs;  ///< yes: > 0 all over the box, no: < 0
    Truth inside;                  ///< whether the box is in the region
    std::span<const int> undecided;
    Truth of(int primitive) const { return signs[primitive]; }
    Truth of(const BooleanExpression& expression) const { return expression.evaluate(signs); }
  };

  /// Boxes go down to 2⁻¹⁰ of the bounds, in space to 2⁻⁶.
  SignTree(const RegionEvaluator& region, const Box& bounds);

  const RegionEvaluator& region() const { return region_; }
  const Box& bounds() const { return bounds_; }

  /// Visits the boxes that `is_undecided(node)` keeps; `leaf(node)` looks at the smallest of
  /// them and stops the search by returning false.
  template <class IsUndecided, class Leaf>
  void search(const IsUndecided& is_undecided, const Leaf& leaf) {
    visit(0, is_undecided, leaf);
  }

 private:
  // Only what the box adds to what is known of the one it is half of.
  struct Part {
    Box box;
    Truth inside;
    std::vector<std::pair<int, Truth>> decided;
    std::vector<int> undecided;
    int first_half = -1;  // the other one follows
  };

  // The signs of a part's box, as long as this lives.
  class SignsOfPart {
   public:
    SignsOfPart(std::vector<Truth>& signs, const Part& part) : signs_(signs), part_(part) {
      for (const auto& [primitive, sign] : part.decided) signs_[primitive] = sign;
    }
    ~SignsOfPart() {
      for (const auto& [primitive, sign] : part_.decided) signs_[primitive] = Truth::unknown;
    }
    SignsOfPart(const SignsOfPart&) = delete;
    SignsOfPart& operator=(const SignsOfPart&) = delete;

   private:
    std::vector<Truth>& signs_;
    const Part& part_;
  };

  // False when the search has been stopped.
  template <class IsUndecided, class Leaf>
  bool visit(int number, const IsUndecided& is_undecided, const Leaf& leaf) {
    const Part& part = parts_[number];
    const SignsOfPart signs(signs_, part);
    const Node node{part.box, signs_, part.inside, part.undecided};
    if (!is_undecided(node)) return true;
    if (part.box.longest_side() <= smallest_) return leaf(node);
    halve(number);
    for (const int half : {part.first_half, part.first_half + 1})
      if (!visit(half, is_undecided, leaf)) return false;
    return true;
  }

  void add(const Box& box, const std::vector<int>& undecided, Truth inside);
  void halve(int number);

  const RegionEvaluator& region_;
  Box bounds_;
  double smallest_;
  std::vector<Truth> signs_;  // of the part that a search is at
  std::deque<Part> parts_;
};

}  // namespace rfm
