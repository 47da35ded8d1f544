#pragma once

#include "core/box.hpp"
#include "core/field.hpp"

namespace rfm {

/// |x − point|², a polynomial in the first `dimension` coordinates.
Field square_distance(const Point& point, int dimension);

/// direction · (x − from), an affine function.
Field height_along(const Point& direction, const Point& from, int dimension);

}  // namespace rfm
