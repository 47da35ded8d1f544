#pragma once

#include <vector>

#include "core/circular_edge.hpp"
#include "core/outline.hpp"

namespace rfm {

/// The points within width/2 of a chain of segments and arcs, by its outline (`stroke_outline`) as
/// a curved polygon: every primitive bounds the stroke, and its function is as smooth as that of a
/// polygon. Compared with the distance from the chain on both sides of each edge; where they
/// differ, or the outline touches itself, by `stroke_union`.
Outline stroke(const std::vector<CircularEdge>& chain, bool closed, double width);

/// The same as a union of a band for each segment (between its two offsets and its ends), a part of
/// a ring for each arc, and a disk about each joint and end. Right for every chain, as each point
/// near it lies in one of them; less smooth, as functions have kinks inside where parts overlap.
/// Sides are `left`, `right`, `start` and `end` as those of an outline: a disk about a joint is of
/// the side on which it sticks out.
Outline stroke_union(const std::vector<CircularEdge>& chain, bool closed, double width);

/// Whether a region agrees with the distance from a chain beside the edges of the chain's outline
/// and in the middle of the stroke.
bool is_stroke(const Region& region, const std::vector<CircularEdge>& chain,
               const std::vector<CircularEdge>& outline, double width);

}  // namespace rfm
