#pragma once

#include <span>

#include "core/field_source.hpp"

namespace rfm {

/// A choice of the direction in which surfaces are written as graphs.
struct HeightDirection {
  static constexpr int none = -1;
  /// The best axis that is proved to serve: over the whole box every surface is a graph over the
  /// other axes, not steeper than 1 / `flatness`, or independent of this axis.
  int proven = none;
  /// The axis that comes nearest, for a best effort.
  int likely = 0;
};

/// Of the axes that serve, the one where the changes of the surfaces along it dominate most.
/// Surfaces that may fail to be differentiable in the box leave no proven axis.
HeightDirection choose_height(const Box& box, std::span<const FunctionBounds> surfaces,
                              double flatness);

}  // namespace rfm
