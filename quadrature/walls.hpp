#pragma once

#include <algorithm>
#include <vector>

#include "quadrature/active_set.hpp"

namespace rfm {

/// A place of an axis at which surfaces stand across it, and the signs of such surfaces on both
/// sides of it.
struct Wall {
  double position = 0;
  SurfaceSigns left = 0;
  SurfaceSigns right = 0;
};

/// The walls among the zeros `standing` of surfaces that depend on the axis alone, of which
/// `signs(place)` gives the signs: zeros nearer than rounding are one wall, and those where no sign
/// changes are none. On a side of the box the state beyond is the sign on the side itself
/// (sign(0) = +), so that a face on a side shared by boxes is met exactly once. Sorts `standing`.
template <class Signs>
void find_walls(std::vector<double>& standing, double low, double high, Signs&& signs,
                std::vector<Wall>& walls) {
  walls.clear();
  std::ranges::sort(standing);
  const double same = 1e-13 * (high - low);
  for (std::size_t i = 0; i < standing.size(); ++i) {
    const double place = standing[i];
    if (i > 0 && place - standing[i - 1] <= same) continue;
    double before = low, after = high;
    for (const double other : standing) {
      if (other < place - same) before = std::max(before, other);
      if (other > place + same) after = std::min(after, other);
    }
    const Wall wall{place, signs(place - low > same ? 0.5 * (before + place) : low),
                    signs(high - place > same ? 0.5 * (place + after) : high)};
    if (wall.left != wall.right) walls.push_back(wall);
  }
}

}  // namespace rfm
