#pragma once

#include "core/box.hpp"
#include "core/quadric.hpp"

namespace rfm {

/// Whether two quadrics are proved to vanish nowhere together in a box: where both are zero, so is
/// every f − λ g, and the member of this pencil whose gradient is least in the middle of the box
/// has one sign. Of concentric circles and spheres, coaxial cylinders and cones and parallel planes
/// it is a constant, so that they are told apart down to some 10⁻¹⁴ of the box, where bounds of
/// their slopes would need boxes as small as the gap. False where nothing is proved, and for
/// functions that are no quadrics (null). Rounded outwards.
bool are_apart(const Quadric* f, const Quadric* g, const Box& box);

}  // namespace rfm
