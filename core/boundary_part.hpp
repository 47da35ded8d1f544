#pragma once

#include <optional>
#include <vector>

#include "core/region.hpp"

namespace rfm {

/// Which part of a primitive's piece of boundary a question selects.
struct BoundaryPart {
  enum class Extent { none, all, some };
  Extent extent = Extent::none;
  /// Where it is ≥ 0, on the piece, is the part; of use for `some`.
  Field where = 1.0;
  /// Smooth functions, one of which is zero wherever the part ends.
  std::vector<Field> ends;
};

/// Whether two functions are the same, or the same polynomial of degree ≤ 2 up to a factor and
/// rounding: then they have the same zeros.
bool same_surface(const Field& a, const Field& b, int dimension);

/// The slope |∇Q| of a polynomial of degree ≤ 2 on its zero set where that is one constant, as of
/// planes, spheres and circular cylinders: |∇Q|² = g² + κQ identically.
std::optional<double> constant_slope(const Field& function, int dimension);

/// Where the outward normal of a piece lies within `angle` (radians, below π) of `direction`:
/// n·d ≥ cos(angle). On planes all or none; on spheres and circular cylinders `where` is affine,
/// on right circular cones affine on each nappe (|∇Q| is proportional to the height there), and
/// elsewhere it is that of the primitive normalised by eq. (4.9), without singularities off the
/// piece. Throws `InvalidArgument` for a direction without length.
BoundaryPart part_with_normal(int primitive, const RegionEvaluator& region, const Point& direction,
                              double angle);

/// Where a piece lies in the closed set `shape`. A surface that the shape shares with the piece (a
/// common primitive, or the same polynomial of degree ≤ 2 up to a factor) belongs to the closed set
/// and decides nothing, so that faces that coincide touch despite rounding.
BoundaryPart part_touching(int primitive, const RegionEvaluator& region, const Region& shape);

}  // namespace rfm
