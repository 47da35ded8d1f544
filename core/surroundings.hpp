#pragma once

#include <vector>

#include "core/region.hpp"

namespace rfm {

/// What lies around a point where primitives vanish together.
struct Surroundings {
  std::vector<int> vanishing;
  /// Signs of the primitives at the point, `unknown` for those that vanish.
  std::vector<Truth> signs;
  bool any_inside = false;
  bool any_outside = false;
};

/// Looks at the open cells around `point`, `reach` away: in the directions between the tangents of
/// the primitives that vanish there (within `tolerance` to first order), and in many others. Signs
/// of primitives that do not vanish are those at the point.
Surroundings surroundings(const RegionEvaluator& region, const Point& point, double tolerance,
                          double reach);

}  // namespace rfm
