#pragma once

#include "core/box.hpp"

namespace rfm {

/// On which side of the line from a to b the point c lies in the plane: 1 left, −1 right, 0 on the
/// line. Exact for all coordinates whose products do not under- or overflow: the sign of the
/// determinant in floating point where its error bound allows (Shewchuk 1997), else of an exact sum
/// of its terms.
int orientation(const Point& a, const Point& b, const Point& c);

}  // namespace rfm
