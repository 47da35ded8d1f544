#pragma once

#include <vector>

#include "core/thin_set.hpp"

namespace rfm {

/// A piece of a closed curve, the way it is walked.
struct LoopPiece {
  std::size_t piece = 0;  ///< its number among those given
  Point from{}, to{};
  double bulge = 0;  ///< of an arc: the tangent of a quarter of its angle, positive to the left
};

/// Segments and arcs in the plane as closed curves, each piece beginning where the one before it
/// ends; ends are the same within 10⁻⁹ of the size of all. Full circles are loops of two halves.
/// Throws `InvalidArgument` for other sets, for none, and if the pieces do not close.
std::vector<std::vector<LoopPiece>> closed_loops(const std::vector<ThinSet>& pieces);

}  // namespace rfm
