#pragma once

#include "core/field.hpp"
#include "core/field_source.hpp"

namespace rfm {

/// |x − p(x)|², the square of the distance to a segment, p(x) its point nearest to x.
///
/// Convex and continuously differentiable, with gradient 2 (x − p); a polynomial of degree 2 beside
/// the segment and beyond each end. Second derivatives jump across the planes through the ends,
/// where jets are those of the part beside the segment. Where the segment runs along an axis the
/// places of its ends are breakpoints, so that quadrature keeps its full order.
class SegmentDistance final : public FieldSource {
 public:
  /// Throws `InvalidArgument` if the ends coincide or the dimension is not 2 or 3.
  SegmentDistance(const Point& from, const Point& to, int dimension = 3);

  void evaluate(const std::array<const double*, 3>& coordinates, int count, int variables,
                int order, double* jets, int stride) const override;
  /// The value from above by convexity (corners), from below by that (a tangent) and by the
  /// components of x − p, whose bounds are also those of the gradient: of second order throughout.
  /// Rounding is covered by 2·10⁻¹⁵ or more of the sizes involved.
  FunctionBounds bounds(const Box& box) const override;
  std::vector<double> breakpoints(int axis) const override;
  Box valid() const override;

 private:
  struct Nearest {
    Point offset{};     ///< x − p(x)
    double beside = 0;  ///< 1 beside the segment, 0 beyond an end: whether p moves with x
  };
  Nearest nearest(const Point& point) const;

  int dimension_;
  Point from_, to_, direction_{};  // of unit length
  double length_ = 0;
};

}  // namespace rfm
