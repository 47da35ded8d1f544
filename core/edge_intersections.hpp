#pragma once

#include <vector>

#include "core/circular_edge.hpp"

namespace rfm {

/// The points where the lines or circles of two edges cross, by closed forms, refined by Newton's
/// method on their distances; nothing where they are parallel, concentric or only touch. Whether
/// the points lie on the edges is for the caller to see.
std::vector<Point> crossings(const CircularEdge& a, const CircularEdge& b);

}  // namespace rfm
