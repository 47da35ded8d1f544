#include "solvers/nested_dissection.hpp"

#include <algorithm>
#include <array>

namespace rfm {
namespace {

// A function with the grid lines before and behind its support.
struct Node {
  std::int64_t number;
  std::array<int, 3> low, high;
};

// Parts with fewer functions are eliminated in their natural order.
constexpr int smallest_part = 96;

class Dissection {
 public:
  Dissection(std::vector<Node> nodes, int dimension)
      : nodes_(std::move(nodes)), dimension_(dimension) {}

  std::vector<std::int64_t> order() {
    dissect(nodes_.begin(), nodes_.end());
    std::vector<std::int64_t> order;
    for (const Node& node : nodes_) order.push_back(node.number);
    return order;
  }

 private:
  using Iterator = std::vector<Node>::iterator;

  void dissect(Iterator begin, Iterator end) {
    if (end - begin <= smallest_part) return;
    const int axis = longest_axis(begin, end);
    const Iterator middle = begin + (end - begin) / 2;
    const auto center = [axis](const Node& node) { return node.low[axis] + node.high[axis]; };
    std::nth_element(begin, middle, end,
                     [&](const Node& a, const Node& b) { return center(a) < center(b); });
    const int line = center(*middle) / 2;
    const Iterator behind = std::stable_partition(
        begin, end, [&](const Node& node) { return node.high[axis] <= line; });
    const Iterator separator = std::stable_partition(
        behind, end, [&](const Node& node) { return node.low[axis] >= line; });
    if (behind == begin && separator == behind) return;  // all straddle the line
    dissect(begin, behind);
    dissect(behind, separator);
  }

  int longest_axis(Iterator begin, Iterator end) const {
    int longest = 0, extent = -1;
    for (int axis = 0; axis < dimension_; ++axis) {
      int low = begin->low[axis], high = begin->high[axis];
      for (Iterator node = begin; node != end; ++node) {
        low = std::min(low, node->low[axis]);
        high = std::max(high, node->high[axis]);
      }
      if (high - low > extent) {
        extent = high - low;
        longest = axis;
      }
    }
    return longest;
  }

  std::vector<Node> nodes_;
  int dimension_;
};

}  // namespace

std::vector<std::int64_t> nested_dissection(std::span<const TensorProductSpace> spaces) {
  std::vector<Node> nodes;
  for (const TensorProductSpace& space : spaces)
    for (int function = 0; function < space.size(); ++function) {
      Node node{static_cast<std::int64_t>(nodes.size()), {}, {}};
      node.low = node.high = space.place(space.spline_of_function(function));
      for (int axis = 0; axis < space.dimension(); ++axis) {
        node.low[axis] -= space.degree();
        ++node.high[axis];
      }
      nodes.push_back(node);
    }
  return Dissection(std::move(nodes), spaces.empty() ? 0 : spaces[0].dimension()).order();
}

}  // namespace rfm
