#pragma once

#include <vector>

#include "core/thin_set.hpp"

namespace rfm {

/// Points of a piece of a boundary that has a `surface`, away from its ends and in general position
/// on it: of segments, arcs and triangles as many as are needed to see their size, of others those
/// that a search of `bounds` meets first (a thousand boxes, halved). None if there are none.
std::vector<Point> points_on(const ThinSet& piece, const Box& bounds);

/// The longest side of the box of points.
double extent_of(const std::vector<Point>& points);

}  // namespace rfm
