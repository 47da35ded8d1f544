#pragma once

#include <utility>
#include <vector>

#include "core/box.hpp"

namespace rfm {

/// Boxes of things (triangles, edges) in a tree, for finding those near a point.
class BoxTree {
 public:
  /// Item i has the box boxes[i]; there is at least one.
  explicit BoxTree(const std::vector<Box>& boxes);

  /// Calls `visit(item)` for items whose boxes are nearer to `point` than √`limit()`, which may
  /// fall meanwhile: near ones first. (Items of a leaf are visited together.)
  template <class Visit, class Limit>
  void walk(const Point& point, const Visit& visit, const Limit& limit) const {
    walk(0, point, visit, limit);
  }

  /// The square of the distance of a point from a box.
  static double square_distance(const Box& box, const Point& point);

 private:
  struct Node {
    Box box;
    int begin, end;  ///< items
    int left = -1, right = -1;
  };
  int build(const std::vector<Box>& boxes, int begin, int end);

  template <class Visit, class Limit>
  void walk(int node, const Point& point, const Visit& visit, const Limit& limit) const {
    const Node& here = nodes_[node];
    if (square_distance(here.box, point) > limit()) return;
    if (here.left < 0) {
      for (int i = here.begin; i < here.end; ++i) visit(items_[i]);
      return;
    }
    int near = here.left, far = here.right;
    if (square_distance(nodes_[far].box, point) < square_distance(nodes_[near].box, point))
      std::swap(near, far);
    walk(near, point, visit, limit);
    walk(far, point, visit, limit);
  }

  std::vector<int> items_;
  std::vector<Node> nodes_;
};

}  // namespace rfm
