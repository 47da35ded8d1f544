#include "quadrature/reduction_2d.hpp"

#include <algorithm>
#include <cmath>

#include "core/quadric_pencil.hpp"

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
  higher_ = proofs.higher;
  known_heights_.clear();
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
      if (meeting == Meeting::unknown &&
          (proven_apart(plane_, graph(i), graph(j)) ||
           are_apart(active.surfaces[i]->quadric(), active.surfaces[j]->quadric(), plane.box)))
        continue;
      add_crossings(i, j, meeting == Meeting::at_most_once);
    }
  find_walls(
      standing_, plane.box.low[base()], plane.box.high[base()],
      [&](double place) { return vertical_signs(place); }, walls_);
}

void Reduction2D::add_found(std::vector<double>& found, int cause) {
  for (const double position : found) breakpoints_.push_back({position, cause});
  found.clear();
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
    add_found(found_, end_cause(surface, end));
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
      certified_ &= isolate_crossings(plane_, p, q, from, to, found_, contacts_);
    }
  }
  if (found_.empty() && contacts_.empty()) return;
  add_found(found_, crossing_cause(first, second));
  add_found(contacts_, Breakpoint::contact);
  std::ranges::sort(breakpoints_, {}, &Breakpoint::position);
}

// Places between which two graphs stay in the box and do not cross; what else happens there does
// not concern them.
Interval Reduction2D::common_range(int first, int second, double place) const {
  const std::array causes{end_cause(first, 0), end_cause(first, 1), end_cause(second, 0),
                          end_cause(second, 1), crossing_cause(first, second)};
  Interval range = plane_.box.interval(base());
  for (const auto& [position, cause] : breakpoints_) {
    if (std::ranges::find(causes, cause) == causes.end()) continue;
    if (position <= place) range.low = std::max(range.low, position);
    if (position >= place) range.high = std::min(range.high, position);
  }
  return range;
}

// Of two graphs at a place of the base axis; beyond an end of the line by Newton's method.
double Reduction2D::height_over(int first, int second, double place) const {
  double heights[2];
  for (int k = 0; k < 2; ++k) {
    const PlaneGraph one = graph(k == 0 ? first : second);
    const LineSegment line = height_line(plane_, one, place);
    const Crossing crossing = find_crossing(*one.surface, line);
    heights[k] = crossing.position;
    double slope = 0;
    for (int step = 0; step < 3 && !crossing.exists; ++step)
      heights[k] -= one.surface->value_and_slope(line.at(heights[k]), height(), slope) / slope;
  }
  return heights[0] - heights[1];
}

double Reduction2D::height_over(int first, int second, const LineSegment& line) const {
  if (first > second) return -height_over(second, first, line);
  if (higher_[first] >> second & 1) return plane_.height_length();
  if (higher_[second] >> first & 1) return -plane_.height_length();
  const double place = line.through[base()];
  for (const KnownHeight& known : known_heights_)
    if (known.first == first && known.second == second && known.range.contains(place))
      return known.height;
  const Interval range = common_range(first, second, place);
  KnownHeight known{first, second, range, 0};
  const auto look = [&](double there) {
    const double height = height_over(first, second, there);
    if (std::fabs(height) > std::fabs(known.height)) known.height = height;
  };
  for (const double t : {0.05, 0.29, 0.53, 0.74, 0.97}) look(range.low + t * range.width());
  // Graphs that touch near a side of the box leave it before they are apart.
  constexpr double short_range = 1e-3;
  const double near = same_height(line);
  for (double reach = std::max(range.width(), 1e-9 * plane_.base_length());
       reach < short_range * plane_.base_length(); reach *= 4) {
    if (std::fabs(known.height) > near) break;
    look(std::max(range.low - reach, plane_.box.low[base()]));
    look(std::min(range.high + reach, plane_.box.high[base()]));
  }
  known_heights_.push_back(known);
  return known.height;
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
