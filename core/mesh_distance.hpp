#pragma once

#include <vector>

#include "core/box_tree.hpp"
#include "core/field_source.hpp"

namespace rfm {

using Triangle = std::array<Point, 3>;

/// The point of a triangle nearest to `point`, and the dimension of the feature it lies on: 2 of
/// the face, 1 of an edge, 0 of a corner, with the directions in which it moves with the point.
struct TrianglePoint {
  Point nearest{};
  int directions = 0;
  std::array<Point, 2> direction{};  ///< orthonormal
};
TrianglePoint nearest_point(const Triangle& triangle, const Point& point);

/// The square of the distance from a set of triangles in space, found by a tree of boxes. It
/// has kinks where the nearest point is not one alone; elsewhere it is continuously differentiable,
/// with second derivatives that jump where the nearest point passes an edge; derivatives beyond the
/// second are 0. Bounds are of second order: every triangle's square distance is convex, and its
/// gradient 2(x − p) changes by at most twice as much as x.
class MeshSquareDistance final : public FieldSource {
 public:
  /// Throws `InvalidArgument` without triangles.
  explicit MeshSquareDistance(std::vector<Triangle> triangles);

  void evaluate(const std::array<const double*, 3>& coordinates, int count, int variables,
                int order, double* jets, int stride) const override;
  FunctionBounds bounds(const Box& box) const override;
  std::vector<double> breakpoints(int axis) const override;
  Box valid() const override;

 private:
  int nearest_triangle(const Point& point) const;

  std::vector<Triangle> triangles_;
  BoxTree tree_;
};

}  // namespace rfm
