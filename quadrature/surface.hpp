#pragma once

#include "core/level_function.hpp"
#include "quadrature/work.hpp"

namespace rfm {

/// A rotated coordinate system of the plane: (ξ, η) ↦ origin + ξ axes[0] + η axes[1].
struct Frame {
  Point origin{};
  std::array<Point, 2> axes{};

  Point to_world(const Point& local) const;
  /// Rotation alone, for normals.
  Point rotate(const Point& local) const;
  /// Components of a world vector (a gradient) along the axes.
  Point components(const Point& world) const;
  /// The axis-parallel box in the world around the image of `local`.
  Box hull(const Box& local) const;
};

/// A level function as the reduction of cells sees it: itself, the same in a rotated frame, or a
/// half-plane (the side of a cell in a rotated frame) or half-space. Coordinates are those of the
/// frame. Cheap to copy; refers to the level function and the frame, which must outlive it.
class Surface {
 public:
  explicit Surface(const LevelFunction& level, const Frame* frame = nullptr)
      : level_(&level), frame_(frame) {}
  /// The same surface seen from a frame of the plane.
  Surface in_frame(const Frame& frame) const;
  /// Tells what the surface costs; until then it counts as a closed form.
  void set_cost(const WorkCost& cost) { cost_ = cost; }
  const WorkCost& cost() const { return cost_; }
  /// The half-plane offset + normal · (ξ, η) ≥ 0, or half-space.
  Surface(double offset, const Point& normal) : offset_(offset), normal_(normal) {}

  double value(const Point& point) const {
    return level_ && !frame_ ? level_->value(point) : other_value(point);
  }
  double value_and_slope(const Point& point, int axis, double& slope) const {
    return level_ && !frame_ ? level_->value_and_slope(point, axis, slope)
                             : other_slope(point, axis, slope);
  }
  double value_and_gradient(const Point& point, Point& gradient) const {
    return level_ && !frame_ ? level_->value_and_gradient(point, gradient)
                             : other_gradient(point, gradient);
  }
  /// Bounds over a box of the frame; those in a rotated frame come from the hull of the box.
  FunctionBounds bounds(const Box& box) const;
  /// The level function itself; null for a half-plane.
  const LevelFunction* level() const { return level_; }
  /// The polynomial, of degree ≤ 2, in the world's coordinates; null for others.
  const QuadricEvaluator* quadric() const {
    return level_ && !frame_ ? level_->quadric() : nullptr;
  }

 private:
  FunctionBounds plane_bounds(const Box& box) const;
  double other_value(const Point& point) const;
  double other_slope(const Point& point, int axis, double& slope) const;
  double other_gradient(const Point& point, Point& gradient) const;

  const LevelFunction* level_ = nullptr;
  const Frame* frame_ = nullptr;
  double offset_ = 0;
  Point normal_{};
  WorkCost cost_;
};

}  // namespace rfm
