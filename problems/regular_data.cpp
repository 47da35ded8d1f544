#include "problems/regular_data.hpp"

#include <algorithm>
#include <vector>

#include "core/least_side.hpp"
#include "core/tape.hpp"

namespace rfm {

bool is_regular(const Field& function, const RegionEvaluator& region, const Box& bounds) {
  if (function.is_constant()) return true;
  const Tape tape({function}, {1}, region.dimension());
  const double smallest = std::max(0x1p-6 * bounds.longest_side(), least_side(bounds));
  std::vector<Box> pending{bounds};
  while (!pending.empty()) {
    const Box box = pending.back();
    pending.pop_back();
    const FunctionBounds known = tape.bounds(box);
    if (known.smooth && known.value.magnitude() < 1e150) continue;
    if (region.contains(box) == Truth::no) continue;
    if (box.longest_side() <= smallest) return false;
    for (const Box& half : bisect(box, box.longest_axis())) pending.push_back(half);
  }
  return true;
}

}  // namespace rfm
