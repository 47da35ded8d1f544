#include "core/sign_tree.hpp"

#include <algorithm>
#include <numeric>

#include "core/least_side.hpp"

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
  smallest_ = std::max((bounds.dimension == 3 ? 0x1p-6 : 0x1p-10) * start.longest_side(),
                       least_side(start));
  std::vector<int> all(region.primitive_count());
  std::iota(all.begin(), all.end(), 0);
  signs_.resize(all.size(), Truth::unknown);
  add(start, all, Truth::unknown);
}

// With the signs of the box that it is half of; `inside` is what is known of that one.
void SignTree::add(const Box& box, const std::vector<int>& undecided, Truth inside) {
  Part part{box, inside, {}, {}};
  for (const int k : undecided) {
    Interval range = region_.level(k).value_bounds(box);
    if (range.contains(0)) range = region_.level(k).bounds(box).value;
    // Not ≥ 0 but > 0: a zero on the very edge of the box counts as a contact.
    if (range.low > 0)
      part.decided.emplace_back(k, Truth::yes);
    else if (range.high < 0)
      part.decided.emplace_back(k, Truth::no);
    else
      part.undecided.push_back(k);
  }
  if (inside == Truth::unknown) {
    const SignsOfPart signs(signs_, part);
    part.inside = region_.region().expression().evaluate(signs_);
  }
  parts_.push_back(std::move(part));
}

void SignTree::halve(int number) {
  Part& part = parts_[number];
  if (part.first_half >= 0) return;
  part.first_half = static_cast<int>(parts_.size());
  for (const Box& half : bisect(part.box, part.box.longest_axis()))
    add(half, part.undecided, part.inside);
}

}  // namespace rfm
