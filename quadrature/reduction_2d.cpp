#include "quadrature/reduction_2d.hpp"

#include <cmath>

#include "quadrature/root_isolation.hpp"

namespace rfm {

LineSegment Reduction2D::line(double place) const {
  LineSegment segment;
  segment.through[base()] = place;
  segment.axis = height_;
  segment.low = box_.low[height_];
  segment.high = box_.high[height_];
  return segment;
}

void Reduction2D::build(const Box& box, const ActiveSet& active,
                        std::span<const FunctionBounds> bounds, int height, const Frame* frame) {
  box_ = box;
  active_ = &active;
  bounds_ = bounds;
  height_ = height;
  frame_ = frame;
  certified_ = true;
  vertical_ = 0;
  for (int i = 0; i < active.count; ++i)
    if (bounds[i].gradient[height].is_zero()) vertical_ |= 1u << i;
  breakpoints_.assign({box.low[base()], box.high[base()]});
  standing_.clear();
  walls_.clear();
  for (int i = 0; i < active.count; ++i) add_ends_of_graphs(i);
  sort_breakpoints();
  for (int i = 0; i < active.count; ++i)
    for (int j = i + 1; j < active.count; ++j)
      if (!is_vertical(i) && !is_vertical(j) && !proven_apart(i, j)) add_crossings(i, j);
  find_walls();
}

void Reduction2D::sort_breakpoints() { std::sort(breakpoints_.begin(), breakpoints_.end()); }

// Roots along the bottom and the top of the box, or anywhere for a vertical surface.
void Reduction2D::add_ends_of_graphs(int surface) {
  const Surface& function = *active_->surfaces[surface];
  const double low = box_.low[base()], high = box_.high[base()];
  const auto& gradient = bounds_[surface].gradient;
  const double zero = 1e-14 * (gradient[base()].magnitude() * (high - low) +
                               gradient[height_].magnitude() * box_.length(height_));
  const int edges = is_vertical(surface) ? 1 : 2;
  for (int edge = 0; edge < edges; ++edge) {
    const double level = is_vertical(surface) ? 0.5 * (box_.low[height_] + box_.high[height_])
                         : edge == 0          ? box_.low[height_]
                                              : box_.high[height_];
    Box side = box_;
    side.low[height_] = side.high[height_] = level;
    const FunctionBounds on_side = function.bounds(side);
    if (on_side.value.excludes_zero()) continue;
    Point point{};
    point[height_] = level;
    const auto value = [&](double t, double& slope) {
      point[base()] = t;
      return function.value_and_slope(point, base(), slope);
    };
    const auto slopes = [&](double from, double to) {
      if (from == low && to == high) return on_side.gradient[base()];
      side.low[base()] = from;
      side.high[base()] = to;
      return function.bounds(side).gradient[base()];
    };
    const auto report = [&](double root) {
      breakpoints_.push_back(root);
      if (is_vertical(surface)) standing_.push_back(root);
    };
    IsolationBudget budget;
    isolate_roots(value, slopes, low, high, zero, report, budget);
    certified_ &= !budget.exhausted;
  }
}

// Mean value form of the difference of two graphs: parallel slopes cancel.
bool Reduction2D::proven_apart(int first, int second) const {
  const auto &p = bounds_[first].gradient, &q = bounds_[second].gradient;
  if (!p[height_].excludes_zero() || !q[height_].excludes_zero()) return false;
  const Point center = box_.center();
  const double radius = 0.5 * box_.length(base());
  const Interval difference =
      Interval(active_->surfaces[second]->value(center)) / q[height_] -
      Interval(active_->surfaces[first]->value(center)) / p[height_] +
      (q[base()] / q[height_] - p[base()] / p[height_]) * Interval(-radius, radius);
  return difference.excludes_zero();
}

// Roots of D(ξ) = h₁(ξ) − h₂(ξ), the difference of the heights of two graphs, wherever both exist.
void Reduction2D::add_crossings(int first, int second) {
  const std::array<int, 2> pair{first, second};
  const auto height = [&](int k, double place) {
    return find_crossing(*active_->surfaces[pair[k]], line(place));
  };
  const auto difference = [&](double place, double& slope) {
    std::array<double, 2> heights{}, slopes{};
    for (int k = 0; k < 2; ++k) {
      heights[k] = height(k, place).position;
      Point gradient{};
      active_->surfaces[pair[k]]->value_and_gradient(line(place).at(heights[k]), gradient);
      slopes[k] = -gradient[base()] / gradient[height_];
    }
    slope = slopes[0] - slopes[1];
    return heights[0] - heights[1];
  };
  // Slopes over [from, to] need the graph only where it can be there: its height in the middle
  // give or take its slope. With the whole height of the box tangential contacts cost 1000 times
  // more.
  const auto slope_bounds = [&](double from, double to) {
    std::array<Interval, 2> slopes;
    const double radius = 0.5 * (to - from);
    for (int k = 0; k < 2; ++k) {
      const auto& wide = bounds_[pair[k]].gradient;
      const double middle = height(k, 0.5 * (from + to)).position;
      const double reach = (wide[base()] / wide[height_]).magnitude() * radius;
      Box narrow = box_;
      narrow.low[base()] = from;
      narrow.high[base()] = to;
      if (middle - reach > narrow.low[height_]) narrow.low[height_] = middle - reach;
      if (middle + reach < narrow.high[height_]) narrow.high[height_] = middle + reach;
      const FunctionBounds local = active_->surfaces[pair[k]]->bounds(narrow);
      slopes[k] = -(local.gradient[base()] / local.gradient[height_]);
    }
    return slopes[0] - slopes[1];
  };
  found_.clear();
  for (std::size_t i = 0; i + 1 < breakpoints_.size(); ++i) {
    const double from = breakpoints_[i], to = breakpoints_[i + 1];
    const double middle = 0.5 * (from + to);
    if (to - from <= negligible_width() || !height(0, middle).exists || !height(1, middle).exists)
      continue;
    IsolationBudget budget;
    isolate_roots(difference, slope_bounds, from, to, 1e-13 * box_.length(height_),
                  [&](double root) { found_.push_back(root); }, budget);
    certified_ &= !budget.exhausted;
  }
  if (found_.empty()) return;
  breakpoints_.insert(breakpoints_.end(), found_.begin(), found_.end());
  sort_breakpoints();
}

SurfaceSigns Reduction2D::vertical_signs(double place) const {
  SurfaceSigns signs = 0;
  const LineSegment segment = line(place);
  const Point point = segment.at(0.5 * (segment.low + segment.high));
  for (int i = 0; i < active_->count; ++i)
    if (is_vertical(i) && active_->surfaces[i]->value(point) >= 0) signs |= 1u << i;
  return signs;
}

void Reduction2D::find_walls() {
  if (standing_.empty()) return;
  std::sort(standing_.begin(), standing_.end());
  const double low = box_.low[base()], high = box_.high[base()];
  const double same = 1e-13 * (high - low);
  for (std::size_t i = 0; i < standing_.size(); ++i) {
    const double place = standing_[i];
    if (i > 0 && place - standing_[i - 1] <= same) continue;
    double before = low, after = high;
    for (const double other : standing_) {
      if (other < place - same) before = std::max(before, other);
      if (other > place + same) after = std::min(after, other);
    }
    // A wall on a side of the box: the state beyond is the sign on the side itself.
    const Wall wall{place, vertical_signs(place - low > same ? 0.5 * (before + place) : low),
                    vertical_signs(high - place > same ? 0.5 * (place + after) : high)};
    if (wall.left != wall.right) walls_.push_back(wall);
  }
}

}  // namespace rfm
