#pragma once

#include <optional>

#include "quadrature/active_set.hpp"

namespace rfm {

/// A plane across an axis (in the plane: a line) that stands for a surface in a box.
struct FlatSurface {
  Surface plane;
  /// The plane is no side of the box, or the surface has one sign on that side, so that the boxes
  /// on both sides of it agree on whose it is.
  bool is_sure = true;
};

/// The plane that a surface is in a box up to rounding, although its formula depends on all
/// coordinates, as y (3 + x²) = 0 does: where it meets another one at a right angle, both parallel
/// to axes, no axis serves as height of both, but every axis serves with the plane. Proved by the
/// bounds of the surface over the plane and of its slope across; `bounds` are those over the box.
/// Nothing if the surface is not flat, or is known to be independent of all other axes.
std::optional<FlatSurface> find_flat_surface(const Box& box, const Surface& surface,
                                             const FunctionBounds& bounds);

}  // namespace rfm
