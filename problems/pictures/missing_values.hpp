#pragma once

#include <string>

#include "problems/pictures/shown_field.hpp"

namespace rfm {

/// The points of a picture at which what it shows has no finite value: how many, and the first.
struct MissingValues {
  int count = 0;
  Point first{};

  void add(const Point& point) {
    if (count++ == 0) first = point;
  }
};

/// `effect`, with why: the operation that fails at the first of the points, and where it stands,
///
///     the picture is grey at 12 pixels, where log(u) is not a finite number, as at the point
///     (0.25, 0.5): log(-0.1) in log(…)
std::string missing_values_text(const std::string& effect, const MissingValues& missing,
                                const ShownField& shown, int dimension);

}  // namespace rfm
