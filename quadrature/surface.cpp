#include "quadrature/surface.hpp"

#include <algorithm>
#include <cmath>

namespace rfm {

Point Frame::rotate(const Point& local) const {
  return {local[0] * axes[0][0] + local[1] * axes[1][0],
          local[0] * axes[0][1] + local[1] * axes[1][1], 0};
}

Point Frame::to_world(const Point& local) const {
  const Point offset = rotate(local);
  return {origin[0] + offset[0], origin[1] + offset[1], 0};
}

Point Frame::components(const Point& world) const {
  return {world[0] * axes[0][0] + world[1] * axes[0][1],
          world[0] * axes[1][0] + world[1] * axes[1][1], 0};
}

Box Frame::hull(const Box& local) const {
  const Point center = to_world(local.center());
  Box world;
  world.dimension = 2;
  for (int i = 0; i < 2; ++i) {
    // The margin covers the rounding of the image.
    const double radius =
        0.5 * (1 + 1e-12) *
            (std::fabs(axes[0][i]) * local.length(0) + std::fabs(axes[1][i]) * local.length(1)) +
        1e-15 * std::fabs(center[i]);
    world.low[i] = center[i] - radius;
    world.high[i] = center[i] + radius;
  }
  return world;
}

Surface Surface::in_frame(const Frame& frame) const {
  Surface seen = *this;
  seen.frame_ = &frame;
  return seen;
}

FunctionBounds Surface::bounds(const Box& box) const {
  work_done += cost_.bounds;
  if (!frame_ && level_) return level_->bounds(box);
  FunctionBounds result;
  if (level_) {
    const FunctionBounds world = level_->bounds(frame_->hull(box));
    for (int i = 0; i < 2; ++i)
      result.gradient[i] = Interval(frame_->axes[i][0]) * world.gradient[0] +
                           Interval(frame_->axes[i][1]) * world.gradient[1];
    result.value = world.value;
    result.smooth = world.smooth;
  } else {
    return plane_bounds(box);
  }
  const Point center = box.center();
  Interval mean_value = value(center);
  for (int i = 0; i < 2; ++i)
    mean_value =
        mean_value + result.gradient[i] * Interval(box.low[i] - center[i], box.high[i] - center[i]);
  result.value = intersection(result.value, mean_value);
  return result;
}

// Values are exact where the plane is parallel to axes, and on the plane zero.
FunctionBounds Surface::plane_bounds(const Box& box) const {
  FunctionBounds result;
  Point least{}, most{};
  double size = std::fabs(offset_);
  int components = 0;
  for (int i = 0; i < box.dimension; ++i) {
    result.gradient[i] = normal_[i];
    least[i] = normal_[i] >= 0 ? box.low[i] : box.high[i];
    most[i] = normal_[i] >= 0 ? box.high[i] : box.low[i];
    size += std::fabs(normal_[i]) * std::max(std::fabs(box.low[i]), std::fabs(box.high[i]));
    components += normal_[i] != 0;
  }
  const double margin = components > 1 ? 1e-15 * size : 0;
  result.value = Interval(other_value(least) - margin, other_value(most) + margin);
  return result;
}

double Surface::other_value(const Point& point) const {
  if (level_) return level_->value(frame_->to_world(point));
  return offset_ + normal_[0] * point[0] + normal_[1] * point[1] + normal_[2] * point[2];
}

double Surface::other_slope(const Point& point, int axis, double& slope) const {
  Point gradient{};
  const double value = other_gradient(point, gradient);
  slope = gradient[axis];
  return value;
}

double Surface::other_gradient(const Point& point, Point& gradient) const {
  if (!level_) {
    gradient = normal_;
    return other_value(point);
  }
  Point world{};
  const double value = level_->value_and_gradient(frame_->to_world(point), world);
  gradient = frame_->components(world);
  return value;
}

}  // namespace rfm
