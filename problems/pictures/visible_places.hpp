#pragma once

#include <optional>
#include <vector>

#include "problems/output/coverage.hpp"

namespace rfm {

/// Numbers of pixels, row by row; negative ones stand for nothing.
struct NumberedPixels {
  int width = 0, height = 0;
  std::vector<int> number;
};

/// A pixel of a number that is as far as can be from pixels of other numbers and from the sides of
/// the picture: where there is most room for its name.
struct VisiblePlace {
  PixelPosition place;  ///< the middle of the pixel
  double radius = 0;    ///< of the diamond |dx| + |dy| < radius around it that has the same number
};

/// For each number 0 … count − 1 its place; nothing for numbers without pixels. Of equal places the
/// uppermost, then leftmost is taken.
std::vector<std::optional<VisiblePlace>> visible_places(const NumberedPixels& pixels, int count);

}  // namespace rfm
