#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/box.hpp"

namespace rfm {

/// The side down to which the parts of `box` can be bisected: far from the origin doubles are as
/// far apart as this, and the half of a shorter box may be the whole of it.
inline double least_side(const Box& box) {
  double farthest = 0;
  for (int axis = 0; axis < box.dimension; ++axis)
    farthest = std::max({farthest, std::fabs(box.low[axis]), std::fabs(box.high[axis])});
  return 4 * std::numeric_limits<double>::epsilon() * farthest;
}

}  // namespace rfm
