#pragma once

#include <set>

#include "core/region.hpp"

namespace rfm {

/// Primitives whose pieces of the boundary of a region pass into each other with a common tangent,
/// as a cylinder and the ball at its end do, or a plane and the cylinder that rounds its edge: see
/// `Primitive::joins_smoothly`, which shapes that know it by themselves set. Boxes in which two
/// surfaces may be parallel on the boundary are halved (to 2⁻¹⁰ of the bounds, in space 2⁻⁶), and a
/// place where they touch is found from there by Gauss and Newton's method, to rounding. Surfaces
/// that cross at a small angle, or touch with opposite normals, do not join smoothly.
std::set<int> smooth_joints(const RegionEvaluator& region, const Box& bounds);

}  // namespace rfm
