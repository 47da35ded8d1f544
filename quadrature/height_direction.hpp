#pragma once

#include <array>
#include <span>

#include "core/field_source.hpp"

namespace rfm {

/// Directions in which surfaces can be written as graphs.
struct HeightDirections {
  /// Axes that are proved to serve, best first: over the whole box every surface is a graph over
  /// the other axes, not steeper than 1 / `flatness`, or independent of the axis.
  std::array<int, 3> proven{};
  int proven_count = 0;
  /// The axis that comes nearest, for a best effort; −1 where bounds tell nothing.
  int likely = -1;
};

/// Of the axes that serve, those come first along which the changes of the surfaces dominate most.
/// Surfaces that may fail to be differentiable in the box leave no proven axis.
HeightDirections find_heights(const Box& box, std::span<const FunctionBounds> surfaces,
                              double flatness);

/// Where bounds tell nothing: the axis that comes nearest by the gradients of the surfaces at the
/// centre, for a best effort. Those that are no numbers do not count.
int likely_height(const Box& box, std::span<const Point> gradients);

}  // namespace rfm
