#include "problems/pictures/scene_panel.hpp"

#include <fmt/format.h>

#include <cmath>

#include "core/primitives.hpp"

namespace rfm {
namespace {

Region remaining(const Region& region, const std::optional<CutPlane>& cut) {
  if (!cut) return region;
  const Point& normal = cut->normal;
  return region & half_space(cut->point, {-normal[0], -normal[1], -normal[2]}).named("cut");
}

}  // namespace

CutPlane CutPlane::facing(const Box& box, const Point& towards_viewer) {
  int axis = 0;
  for (int other = 1; other < 3; ++other)
    if (std::fabs(towards_viewer[other]) > std::fabs(towards_viewer[axis])) axis = other;
  CutPlane plane{box.center(), {}};
  plane.normal[axis] = std::copysign(1.0, towards_viewer[axis]);
  return plane;
}

std::string CutPlane::equation() const {
  std::string left;
  double right = 0;
  int axes = 0, only_axis = 0;
  for (int axis = 0; axis < 3; ++axis) {
    if (normal[axis] == 0) continue;
    const double factor = normal[axis];
    left += left.empty() ? (factor < 0 ? "-" : "") : factor < 0 ? " - " : " + ";
    if (std::fabs(factor) != 1) left += fmt::format("{:.4g} ", std::fabs(factor));
    left += "xyz"[axis];
    right += factor * point[axis];
    ++axes;
    only_axis = axis;
  }
  if (axes == 1) return fmt::format("{} = {:.4g}", "xyz"[only_axis], point[only_axis] + 0.0);
  return fmt::format("{} = {:.4g}", left, right);
}

ScenePanel::ScenePanel(const Region& region, const Box& bounds, const std::optional<CutPlane>& cut,
                       const View& view)
    : bounds_(bounds),
      view_(view),
      region_(std::make_unique<const RegionEvaluator>(remaining(region, cut))),
      rays_(*region_, bounds) {
  if (cut) cut_primitive_ = region_->primitive_count() - 1;
}

ViewWindow ScenePanel::window() const { return seen_window(rays_, view_, bounds_); }

void ScenePanel::sample(const ViewWindow& window, int width, int height) {
  camera_ = Camera::around(view_, window, width, height);
  samples_ = sample_scene(rays_, camera_);
}

}  // namespace rfm
