#pragma once

#include "core/box.hpp"

namespace rfm {

/// What the sides of a box measure together: more than any surface in it that is convex or monotone
/// in each coordinate, as surfaces are in small boxes but at singular points.
inline double measure_of_sides(const Box& box) {
  double sides = 0;
  for (int axis = 0; axis < box.dimension; ++axis) {
    double side = 2;
    for (int other = 0; other < box.dimension; ++other)
      if (other != axis) side *= box.length(other);
    sides += side;
  }
  return sides;
}

}  // namespace rfm
