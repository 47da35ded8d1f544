#include "quadrature/reduction_2d.hpp"

#include <algorithm>

namespace rfm {

void Reduction2D::build(const Plane& plane, const ActiveSet& active,
                        std::span<const FunctionBounds> bounds, const PlaneProofs& proofs,
                        const Frame* frame) {
  plane_ = plane;
  active_ = &active;
  bounds_ = bounds;
  frame_ = frame;
  certified_ = true;
  touching_ = proofs.touching;
  vertical_ = 0;
  for (int i = 0; i < active.count; ++i)
    if (graph(i).is_vertical(plane)) vertical_ |= 1u << i;
  breakpoints_.assign({{plane.box.low[base()]}, {plane.box.high[base()]}});
  standing_.clear();
  found_.clear();
  walls_.clear();
  for (int i = 0; i < active.count; ++i) add_ends(i, proofs);
  std::ranges::sort(breakpoints_, {}, &Breakpoint::position);
  for (int i = 0; i < active.count; ++i)
    for (int j = i + 1; j < active.count; ++j) {
      const Meeting meeting = proofs.crossings[i][j];
      if (meeting == Meeting::never || is_vertical(i) || is_vertical(j)) continue;
      if (meeting == Meeting::unknown && proven_apart(plane_, graph(i), graph(j))) continue;
      add_crossings(i, j, meeting == Meeting::at_most_once);
    }
  find_walls(
      standing_, plane.box.low[base()], plane.box.high[base()],
      [&](double place) { return vertical_signs(place); }, walls_);
}

void Reduction2D::add_found(int cause) {
  for (const double position : found_) breakpoints_.push_back({position, cause});
  found_.clear();
}

// Roots along the bottom and the top of the box, or anywhere for a vertical surface.
void Reduction2D::add_ends(int surface, const PlaneProofs& proofs) {
  const double low = plane_.box.low[height()], high = plane_.box.high[height()];
  for (int end = 0; end < (is_vertical(surface) ? 1 : 2); ++end) {
    const Meeting meeting = proofs.ends[surface][end];
    if (meeting == Meeting::never) continue;
    const double level = is_vertical(surface) ? 0.5 * (low + high) : end == 0 ? low : high;
    if (meeting == Meeting::unknown) {
      certified_ &= isolate_level(plane_, graph(surface), level, found_);
    } else {
      LineSegment along{plane_.box.low, base(), plane_.box.low[base()], plane_.box.high[base()]};
      along.through[height()] = level;
      const Crossing crossing = find_crossing(*active_->surfaces[surface], along);
      if (crossing.exists) found_.push_back(crossing.position);
    }
    if (is_vertical(surface)) standing_.insert(standing_.end(), found_.begin(), found_.end());
    add_found(end_cause(surface, end));
  }
}

// Where two graphs cross, between breakpoints where both exist.
void Reduction2D::add_crossings(int first, int second, bool at_most_once) {
  const PlaneGraph p = graph(first), q = graph(second);
  const auto exists = [&](const PlaneGraph& graph, double place) {
    const LineSegment line = height_line(plane_, graph, place);
    return (graph.surface->value(line.at(line.low)) >= 0) !=
           (graph.surface->value(line.at(line.high)) >= 0);
  };
  const auto difference = [&](double place, double& slope) {
    return height_difference(plane_, p, q, place, slope);
  };
  for (std::size_t i = 0; i + 1 < breakpoints_.size(); ++i) {
    const double from = breakpoints_[i].position, to = breakpoints_[i + 1].position;
    const double middle = 0.5 * (from + to);
    if (to - from <= negligible_width() || !exists(p, middle) || !exists(q, middle)) continue;
    if (at_most_once) {
      double slope = 0;
      const double low = difference(from, slope), high = difference(to, slope);
      if ((low >= 0) != (high >= 0))
        found_.push_back(bracketed_root(difference, from, to, low, high));
    } else {
      certified_ &= isolate_crossings(plane_, p, q, from, to, found_);
    }
  }
  if (found_.empty()) return;
  add_found(crossing_cause(first, second));
  std::ranges::sort(breakpoints_, {}, &Breakpoint::position);
}

SurfaceSigns Reduction2D::vertical_signs(double place) const {
  SurfaceSigns signs = 0;
  const LineSegment segment = line(place);
  const Point point = segment.at(0.5 * (segment.low + segment.high));
  for (int i = 0; i < active_->count; ++i)
    if (is_vertical(i) && active_->surfaces[i]->value(point) >= 0) signs |= 1u << i;
  return signs;
}

}  // namespace rfm
