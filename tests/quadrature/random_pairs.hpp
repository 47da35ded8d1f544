#pragma once

#include "core/mapped_region.hpp"
#include "tests/quadrature/random_domains.hpp"

namespace rfm::test {

/// Two random domains, the second pushed away by up to most of their size.
struct RandomPair {
  Region first, second;
  Box bounds;
};

inline RandomPair random_pair(unsigned seed, int dimension) {
  std::mt19937 generator(seed);
  Similarity away;
  for (int axis = 0; axis < dimension; ++axis)
    away.translation[axis] = 1.2 * (0x1p-32 * generator() * 2 - 1);
  Box bounds;
  bounds.dimension = dimension;
  for (int axis = 0; axis < dimension; ++axis) {
    bounds.low[axis] = std::max(-1.5, away.translation[axis] - 1.5);
    bounds.high[axis] = std::min(1.5, away.translation[axis] + 1.5);
  }
  return {random_domain(2 * seed, dimension).region(),
          transformed(random_domain(2 * seed + 1, dimension).region(), away), bounds};
}

}  // namespace rfm::test
