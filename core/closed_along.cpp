#include "core/closed_along.hpp"

#include <utility>

#include "core/error.hpp"
#include "core/same_solid.hpp"

namespace rfm {
namespace {

constexpr std::size_t most_independent = 8;

// Numbers of primitives that are multiples of one, with whether their signs are opposite to its.
using Family = std::vector<std::pair<int, bool>>;

std::vector<Family> families(const RegionEvaluator& region, const std::vector<int>& numbers,
                             const Box& bounds) {
  std::vector<Family> list;
  for (const int k : numbers) {
    bool known = false;
    for (Family& family : list) {
      const double ratio =
          ratio_of_multiples(region.level(k), region.level(family[0].first), bounds);
      if (ratio == 0) continue;
      family.emplace_back(k, ratio < 0);
      known = true;
      break;
    }
    if (!known) list.push_back({{k, false}});
  }
  return list;
}

}  // namespace

Region closed_along(const RegionEvaluator& region, const std::vector<int>& vanishing,
                    const Box& bounds) {
  const std::vector<Family> list = families(region, vanishing, bounds);
  if (list.size() > most_independent)
    throw InvalidArgument("more than " + std::to_string(most_independent) +
                          " different surfaces vanish along a set");
  BooleanExpression either = BooleanExpression::constant(false);
  for (unsigned choice = 0; choice < 1u << list.size(); ++choice) {
    BooleanExpression one = region.region().expression();
    for (std::size_t i = 0; i < list.size(); ++i)
      for (const auto& [k, opposite] : list[i])
        one = one.restricted(k, ((choice >> i & 1) != 0) != opposite);
    either = either | one;
  }
  return region.region().with_expression(either);
}

}  // namespace rfm
