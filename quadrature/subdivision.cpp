#include "quadrature/subdivision.hpp"

#include <cmath>

#include "quadrature/height_direction.hpp"
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

}  // namespace

Uncertified Subdivision::run(const Box& box, const ActiveSet& active, PartVisitor& visitor) {
  visitor_ = &visitor;
  frame_ = nullptr;
  max_depth_ = options_.max_depth[box.dimension - 1];
  bisections_ = 0;
  uncertified_ = {};
  visit(box, active, 0);
  return uncertified_;
}

double Subdivision::flatness(int dimension, int depth) const {
  const int relaxed = std::max(0, depth - 3 * (dimension - 1));
  return options_.flatness * std::pow(options_.flatness_decay, relaxed);
}

void Subdivision::visit(const Box& box, ActiveSet active, int depth) {
  SurfaceBounds bounds;
  simplify(box, active, bounds);
  if (active.region_count() == 0 && !active.table.value(0)) return;
  if (active.count == 0) return visitor_->full(box, frame_);
  const std::span known(bounds.data(), static_cast<std::size_t>(active.count));
  const HeightDirection height = choose_height(box, known, flatness(box.dimension, depth));
  if (height.proven != HeightDirection::none)
    return reduce(box, active, known, height.proven, true);
  if (depth >= max_depth_ || bisections_ >= options_.max_bisections)
    return reduce(box, active, known, height.likely, false);
  const bool smooth =
      std::all_of(known.begin(), known.end(), [](const FunctionBounds& b) { return b.smooth; });
  if (box.dimension == 2 && depth >= options_.rotation_depth && smooth &&
      rotated(box, active, depth))
    return;
  bisected(box, active, depth, box.longest_axis());
}

void Subdivision::bisected(const Box& box, const ActiveSet& active, int depth, int axis) {
  ++bisections_;
  for (const Box& half : bisect(box, axis)) visit(half, active, depth + 1);
}

bool Subdivision::rotated(const Box& box, const ActiveSet& active, int depth) {
  // Boxes of the rotated frame are not rotated again.
  if (frame_) return false;
  constexpr int depth_in_frame = 8;
  const std::optional<RotatedBox> rotation = RotatedBox::around(box, active);
  if (!rotation) return false;
  const int max_depth = max_depth_;
  frame_ = &rotation->frame();
  max_depth_ = std::min(depth + depth_in_frame, max_depth);
  visit(rotation->box(), rotation->active(), depth + 1);
  max_depth_ = max_depth;
  frame_ = nullptr;
  return true;
}

void Subdivision::reduce(const Box& box, const ActiveSet& active,
                         std::span<const FunctionBounds> bounds, int height, bool proven) {
  bool certified = proven;
  if (box.dimension == 1) {
    visitor_->reduced(active, {{}, 0, box.low[0], box.high[0]});
  } else {
    plane_.build({box, 1 - height, height}, active, bounds, PlaneProofs(), frame_);
    visitor_->reduced(plane_);
    certified &= plane_.certified();
  }
  if (certified) return;
  ++uncertified_.boxes;
  uncertified_.measure += box.measure();
}

}  // namespace rfm
