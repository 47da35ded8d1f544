#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/region.hpp"

namespace rfm {

/// A side of an outline that is no primitive of its own: a part of one that it shares with other
/// sides, or several primitives (a hole as a whole).
struct OutlineSide {
  std::string name;
  /// Names of primitives.
  std::vector<std::string> pieces;
  /// Only where this is ≥ 0.
  std::optional<Field> where;
};

/// A region whose boundary is given as a list of edges. Edges that lie on one line (or circle, or
/// conic) and have the inside on the same side of it share one primitive, named after the first of
/// them with `_line` added: an R-function of two equal arguments loses its normalisation, and which
/// of two equal primitives a point of the boundary belongs to could not be told.
struct Outline {
  Region region;
  std::vector<OutlineSide> sides;
  /// The Euclidean distance, positive inside, where it was asked for.
  std::optional<Field> distance = {};
};

}  // namespace rfm
