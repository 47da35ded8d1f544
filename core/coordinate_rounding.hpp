#pragma once

#include <span>

#include "core/box.hpp"

namespace rfm {

/// How coarse the coordinates of points of the plane are, as far as their digits tell: the unit of
/// the last decimal place that any of them needs, or 2⁻²⁴ of the largest where all are numbers of
/// single precision (up to that decimal place) and this is more. At least 2⁻⁵² of the largest; 0 if
/// all are 0. Coordinates must be finite.
double coordinate_rounding(std::span<const Point> points);

}  // namespace rfm
