#include "quadrature/subdivision.hpp"

#include <cmath>

#include "quadrature/box_sides.hpp"
#include "quadrature/flat_surface.hpp"
#include "quadrature/rotated_frame.hpp"

namespace rfm {
namespace {

using SurfaceBounds = std::array<FunctionBounds, ActiveSet::capacity>;

void drop(ActiveSet& active, SurfaceBounds& bounds, int surface, bool positive) {
  std::copy(bounds.begin() + surface + 1, bounds.begin() + active.count, bounds.begin() + surface);
  active.fix(surface, positive);
}

// Fixes the surfaces with one sign in the box and drops those on which nothing depends any more.
void simplify(const Box& box, ActiveSet& active, SurfaceBounds& bounds) {
  for (int i = 0; i < active.count;) {
    bounds[i] = active.surfaces[i]->bounds(box);
    if (bounds[i].value.low >= 0 || bounds[i].value.high < 0)
      active.fix(i, bounds[i].value.low >= 0);
    else
      ++i;
  }
  for (int i = 0; i < active.region_count();)
    if (active.table.depends_on(i))
      ++i;
    else
      drop(active, bounds, i, false);
}

// What of the boundary there may be in a box: on each of its surfaces what the sides measure.
double boundary_measure(const Box& box, const ActiveSet& active) {
  int surfaces = 0;
  for (int i = 0; i < active.region_count(); ++i)
    surfaces += active.numbers[i] != ActiveSet::no_piece;
  return surfaces * measure_of_sides(box);
}

}  // namespace

Uncertified Subdivision::run(const Box& box, const ActiveSet& active, PartVisitor& visitor,
                             double share) {
  visitor_ = &visitor;
  frame_ = nullptr;
  max_depth_ = options_.max_depth[box.dimension - 1];
  const WorkLimit limit(static_cast<std::int64_t>(share * static_cast<double>(options_.max_work)));
  is_limited_ = false;
  uncertified_ = {};
  planes_.clear();
  visit(box, active, 0);
  visit_waiting();
  return uncertified_;
}

void Subdivision::visit_waiting() {
  for (next_ = 0; next_ < waiting_.size();) {
    const Waiting box = waiting_[next_++];
    visit(box.box, box.active, box.depth);
  }
  waiting_.clear();
}

int likely_axis(const Box& box, const ActiveSet& active, const HeightDirections& heights) {
  if (heights.likely >= 0) return heights.likely;
  std::array<Point, ActiveSet::capacity> gradients{};
  const Point center = box.center();
  for (int i = 0; i < active.count; ++i)
    active.surfaces[i]->value_and_gradient(center, gradients[i]);
  return likely_height(box, std::span(gradients).first(static_cast<std::size_t>(active.count)));
}

// Whether the budget allows for another bisection and for what the boxes that wait would cost as
// they are: to be bounded and reduced, with some tens of lines and of points each.
bool Subdivision::may_bisect(const ActiveSet& active, int depth) const {
  constexpr std::int64_t lines = 45, reduction = 700;
  if (depth >= max_depth_) return false;
  std::int64_t line = 0;
  for (int i = 0; i < active.count; ++i) line += active.surfaces[i]->cost().crossing;
  return work_done +
             static_cast<std::int64_t>(waiting_.size() - next_ + 2) * (reduction + lines * line) <
         last_work;
}

template <class Reduction>
void Subdivision::report(Reduction& reduction, bool proven) {
  // Small boxes lose little by fewer points; a tenth of the budget later it has to end.
  const std::int64_t overspent = work_done - last_work;
  is_limited_ = overspent > 0;
  const int most_points = !is_limited_                         ? PartQuality::unlimited
                          : 10 * overspent < options_.max_work ? 4
                                                               : 2;
  visitor_->begin({most_points, proven && reduction.certified()});
  visitor_->reduced(reduction);
}

double Subdivision::flatness(int dimension, int depth) const {
  const int relaxed = std::max(0, depth - 3 * (dimension - 1));
  return options_.flatness[dimension - 1] * std::pow(options_.flatness_decay, relaxed);
}

void Subdivision::visit(const Box& box, ActiveSet active, int depth) {
  constexpr int work_to_pass_on = 10;
  work_done += work_to_pass_on;
  SurfaceBounds bounds;
  simplify(box, active, bounds);
  if (active.region_count() == 0 && !active.table.value(0)) return;
  if (active.count == 0) return visitor_->full(box, frame_);
  const std::span known(bounds.data(), static_cast<std::size_t>(active.count));
  const HeightDirections heights = find_heights(box, known, flatness(box.dimension, depth));
  if (reduced(box, active, known, heights, depth)) return;
  if (flattened(box, active, known, depth)) return;
  const bool smooth =
      std::all_of(known.begin(), known.end(), [](const FunctionBounds& b) { return b.smooth; });
  if (box.dimension == 2 && depth >= options_.rotation_depth && smooth &&
      rotated(box, active, depth))
    return;
  int axis = box.longest_axis();
  if (box.dimension == 3 && heights.proven_count == 1) {
    // Across the only height the curves of the base plane would stay as they are.
    const int first = (heights.proven[0] + 1) % 3, second = (heights.proven[0] + 2) % 3;
    axis = box.length(first) >= box.length(second) ? first : second;
  }
  bisect_later(box, active, depth, axis);
}

void Subdivision::bisect_later(const Box& box, const ActiveSet& active, int depth, int axis) {
  for (const Box& half : bisect(box, axis)) waiting_.push_back({half, active, depth + 1});
}

// Planes in the place of surfaces that are flat up to rounding. Where it is chance to which box a
// side belongs this is put off until boxes are small.
bool Subdivision::flattened(const Box& box, const ActiveSet& active,
                            std::span<const FunctionBounds> bounds, int depth) {
  if (frame_) return false;
  ActiveSet flat = active;
  bool is_any = false, is_sure = true;
  for (int i = 0; i < active.count; ++i) {
    const auto found = find_flat_surface(box, *active.surfaces[i], bounds[i]);
    if (!found || (!found->is_sure && depth < options_.rotation_depth)) continue;
    planes_.push_back(found->plane);
    flat.surfaces[i] = &planes_.back();
    is_any = true;
    is_sure &= found->is_sure;
  }
  if (!is_any) return false;
  visit(box, flat, depth);
  if (!is_sure) add_uncertified(box, boundary_measure(box, active));
  return true;
}

// A best effort of the region would pay for what splits its inside alone.
bool Subdivision::without_interfaces(const Box& box, const ActiveSet& active, int depth) {
  if (active.count == active.region_count() || active.region_count() == 0) return false;
  ActiveSet region = active;
  region.count = region.region_count();
  visit(box, region, depth);
  add_uncertified(box, 0);
  return true;
}

bool Subdivision::rotated(const Box& box, const ActiveSet& active, int depth) {
  // Boxes of the rotated frame are not rotated again.
  if (frame_) return false;
  constexpr int depth_in_frame = 8;
  const std::optional<RotatedBox> rotation = RotatedBox::around(box, active);
  if (!rotation) return false;
  // A length of the order of the root of the rounding is lost or counted twice there: the smaller
  // the box, the less.
  constexpr int levels_from_bottom = 4;
  if (rotation->touches_side() && depth + levels_from_bottom < max_depth_) return false;
  const int max_depth = max_depth_;
  frame_ = &rotation->frame();
  max_depth_ = std::min(depth + depth_in_frame, max_depth);
  std::vector<Waiting> others;
  std::swap(others, waiting_);
  const std::size_t next = next_;
  next_ = 0;
  visit(rotation->box(), rotation->active(), depth + 1);
  visit_waiting();
  std::swap(others, waiting_);
  next_ = next;
  max_depth_ = max_depth;
  frame_ = nullptr;
  if (rotation->touches_side()) {
    constexpr double root_of_rounding = 1e-6;
    add_uncertified(box, root_of_rounding * boundary_measure(box, active));
  }
  return true;
}

// False if the box has to be bisected.
bool Subdivision::reduced(const Box& box, const ActiveSet& active,
                          std::span<const FunctionBounds> bounds, const HeightDirections& heights,
                          int depth) {
  const bool proven = heights.proven_count > 0;
  if (!proven && may_bisect(active, depth)) return false;
  if (box.dimension == 3) return space_reduced(box, active, bounds, heights, depth);
  if (!proven && without_interfaces(box, active, depth)) return true;
  if (box.dimension == 2) {
    const int height = proven ? heights.proven[0] : likely_axis(box, active, heights);
    plane_.build({box, 1 - height, height}, active, bounds, PlaneProofs(), frame_);
    report(plane_, proven);
    const bool certified = proven && plane_.certified();
    if (!certified || is_limited_)
      add_uncertified(box, certified ? 0 : boundary_measure(box, active));
  } else {
    visitor_->reduced(active, {{}, 0, box.low[0], box.high[0]});
    if (!proven) add_uncertified(box, boundary_measure(box, active));
  }
  return true;
}

// Tries the heights in turn.
bool Subdivision::space_reduced(const Box& box, const ActiveSet& active,
                                std::span<const FunctionBounds> bounds,
                                const HeightDirections& heights, int depth) {
  Reduction3D::Options options;
  options.flatness = flatness(box.dimension, depth);
  options.allow_contacts = depth >= options_.contact_depth;
  const bool in_time = work_done < last_work;
  for (int i = 0; i < heights.proven_count && in_time; ++i) {
    const Reduction3D::Outcome outcome =
        space_.build(box, active, bounds, heights.proven[i], options);
    if (outcome == Reduction3D::Outcome::constant_surface) {
      if (space_.has_contacts()) add_contact(box);
      ActiveSet fewer = active;
      fewer.fix(space_.constant_surface(), space_.constant_sign());
      visit(box, fewer, depth);
      return true;
    }
    if (outcome == Reduction3D::Outcome::not_reduced) continue;
    report(space_, !space_.has_contacts());
    if (!space_.certified() || is_limited_) {
      add_uncertified(box, space_.certified() ? 0 : boundary_measure(box, active));
    } else if (space_.has_contacts()) {
      add_contact(box);
    }
    return true;
  }
  if (may_bisect(active, depth)) return false;
  if (without_interfaces(box, active, depth)) return true;
  options.best_effort = true;
  options.in_haste = depth < max_depth_ || 2 * (last_work - work_done) < options_.max_work;
  space_.build(box, active, bounds,
               heights.proven_count > 0 ? heights.proven[0] : likely_axis(box, active, heights),
               options);
  report(space_, false);
  add_uncertified(box, boundary_measure(box, active));
  return true;
}

void Subdivision::add_contact(const Box& box) {
  ++uncertified_.contact_boxes;
  uncertified_.contact_measure += box.measure();
}

void Subdivision::add_uncertified(const Box& box, double missing) {
  ++uncertified_.boxes;
  uncertified_.measure += box.measure();
  visitor_->not_certified(missing);
}

}  // namespace rfm
