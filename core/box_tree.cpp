#include "core/box_tree.hpp"

#include <algorithm>
#include <numeric>

namespace rfm {

BoxTree::BoxTree(const std::vector<Box>& boxes) : items_(boxes.size()) {
  std::iota(items_.begin(), items_.end(), 0);
  build(boxes, 0, static_cast<int>(boxes.size()));
}

int BoxTree::build(const std::vector<Box>& boxes, int begin, int end) {
  constexpr int leaf = 4;
  Node node{boxes[items_[begin]], begin, end};
  for (int i = begin; i < end; ++i)
    for (int axis = 0; axis < node.box.dimension; ++axis) {
      node.box.low[axis] = std::min(node.box.low[axis], boxes[items_[i]].low[axis]);
      node.box.high[axis] = std::max(node.box.high[axis], boxes[items_[i]].high[axis]);
    }
  const int number = static_cast<int>(nodes_.size());
  nodes_.push_back(node);
  if (end - begin <= leaf) return number;
  const int axis = node.box.longest_axis(), middle = (begin + end) / 2;
  const auto place = [&](int item) { return boxes[item].low[axis] + boxes[item].high[axis]; };
  std::nth_element(items_.begin() + begin, items_.begin() + middle, items_.begin() + end,
                   [&](int a, int b) { return place(a) < place(b); });
  const int left = build(boxes, begin, middle), right = build(boxes, middle, end);
  nodes_[number].left = left;
  nodes_[number].right = right;
  return number;
}

double BoxTree::square_distance(const Box& box, const Point& point) {
  double square = 0;
  for (int axis = 0; axis < box.dimension; ++axis) {
    const double below = box.low[axis] - point[axis], above = point[axis] - box.high[axis];
    const double outside = std::max({below, above, 0.0});
    square += outside * outside;
  }
  return square;
}

}  // namespace rfm
