#include "quadrature/interfaces.hpp"

#include <algorithm>

namespace rfm {

void Interfaces::narrow(const Box& box, Truth inside, bool tight, std::vector<int>& numbers) const {
  if (inside == Truth::no) return numbers.clear();
  if (inside == Truth::yes)
    for (const BoundaryEnds& ends : ends_)
      std::erase_if(numbers, [&](int k) { return ends.begin <= k && k < ends.end; });
  std::erase_if(numbers, [&](int k) {
    const LevelFunction& level = levels_[k];
    const Interval value =
        intersection(tight ? level.bounds(box).value : level.value_bounds(box), level.range());
    // What is nowhere positive is zero at most on a set of no measure, which no rule sees.
    return value.low >= 0 || value.high < 0 || level.range().high <= 0;
  });
  for (const BoundaryEnds& ends : ends_) {
    const auto first = std::ranges::lower_bound(numbers, ends.begin);
    const auto last = std::ranges::lower_bound(first, numbers.end(), ends.end);
    if (!ends.locator || first == last) continue;
    std::vector<int> own;
    for (auto k = first; k != last; ++k) own.push_back(*k - ends.begin);
    ends.locator->narrow(box, own);
    const auto place = numbers.erase(first, last);
    for (int& k : own) k += ends.begin;
    numbers.insert(place, own.begin(), own.end());
  }
}

}  // namespace rfm
