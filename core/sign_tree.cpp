#include "core/sign_tree.hpp"

#include <numeric>

namespace rfm {

SignTree::SignTree(const RegionEvaluator& region, const Box& bounds)
    : region_(region), bounds_(bounds) {
  // Enlarged a little, so that contacts on the sides of the bounding box are inside.
  Box start = bounds;
  for (int axis = 0; axis < bounds.dimension; ++axis) {
    const double margin = 1.7e-3 * bounds.longest_side();
    start.low[axis] -= margin;
    start.high[axis] += 1.1 * margin;
  }
  smallest_ = (bounds.dimension == 3 ? 0x1p-6 : 0x1p-10) * start.longest_side();
  std::vector<int> all(region.primitive_count());
  std::iota(all.begin(), all.end(), 0);
  add(start, std::vector<Truth>(all.size(), Truth::unknown), all);
}

void SignTree::add(const Box& box, const std::vector<Truth>& signs,
                   const std::vector<int>& undecided) {
  Node node{box, signs, Truth::unknown, {}};
  for (const int k : undecided) {
    Interval range = region_.level(k).value_bounds(box);
    if (range.contains(0)) range = region_.level(k).bounds(box).value;
    // Not ≥ 0 but > 0: a zero on the very edge of the box counts as a contact.
    node.signs[k] = range.low > 0 ? Truth::yes : range.high < 0 ? Truth::no : Truth::unknown;
    if (node.signs[k] == Truth::unknown) node.undecided.push_back(k);
  }
  node.inside = region_.region().expression().evaluate(node.signs);
  nodes_.push_back(std::move(node));
}

void SignTree::halve(int number) {
  if (nodes_[number].first_half >= 0) return;
  nodes_[number].first_half = static_cast<int>(nodes_.size());
  const Box box = nodes_[number].box;
  for (const Box& half : bisect(box, box.longest_axis()))
    add(half, nodes_[number].signs, nodes_[number].undecided);
}

}  // namespace rfm
