#pragma once

#include <vector>

#include "core/level_function.hpp"

namespace rfm {

/// Where the sign of a level function changes along a part of a line, ascending, sign(0) = +.
struct RayCrossings {
  bool starts_positive = false;
  std::vector<double> positions;
};

/// All sign changes of `level` on [low, high]: of quadrics in closed form, of others isolated by
/// bounds along the line. Touching without a change is no crossing. `gradient` bounds ∇level there;
/// where that tells that the function is monotone, nothing else is asked (quadrics need none).
void find_crossings(const LevelFunction& level,
                    const std::array<Interval, maximum_variables>& gradient, const Line& line,
                    double low, double high, RayCrossings& crossings);

}  // namespace rfm
