#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/outline.hpp"
#include "core/set_description.hpp"
#include "core/thin_set.hpp"

namespace rfm {

/// A solid that is given by the pieces of its boundary, as a Boolean expression.
struct DescribedSolid {
  /// Its primitives are the curves (surfaces) of the pieces, in their order, then the separators
  /// that are needed, which select only. Pieces on one curve share a primitive, with the name of
  /// the first of them and `_line`.
  Region region;
  /// The pieces that share a primitive, each with the part that is its own.
  std::vector<OutlineSide> sides;
  /// A point inside and one outside that the curves of the pieces alone do not tell apart; nothing
  /// if they describe the solid.
  std::optional<std::pair<Point, Point>> conflict;
  int candidates = 0;                   ///< separators that were tried
  std::vector<std::string> separators;  ///< those that are left, in words: "the chord of arc2"
  std::vector<std::string> needless;    ///< those that were taken away
};

/// The inverse problem of analytic geometry (V. Shapiro, Acta Numerica 16 (2007), §5.3): an
/// expression of a solid whose boundary is the union of `pieces`. Where the primitives that the
/// pieces induce do not describe it, separators are added: what divides each curved piece from the
/// rest of its curve or surface, of an arc its chord, of other pieces what they are trimmed by
/// (theorem 6). Lines and chords suffice for segments and arcs, and triangles need none
/// (docs/design.md). Then they are taken away one by one as long as the solid remains describable,
/// so that none of those left is needless (another choice may be smaller).
///
/// Inside is what `membership` says, `bounds` as for `SetDescription`, whose resolution holds here
/// too. Pieces must have a `surface`; `names` are those of the primitives, one for each. Throws
/// `InvalidArgument` otherwise, for more than 64 pieces, if the solid is not describable with all
/// separators, and if a piece bounds nothing of what was found.
DescribedSolid described_solid(const std::vector<ThinSet>& pieces,
                               const std::vector<std::string>& names, const Membership& membership,
                               const Box& bounds);

/// The same of closed curves of segments and arcs (in space of triangles), inside by the parity of
/// the winding number. Straight pieces whose loops do not meet are a `polygon` of any size, with
/// every edge once; elsewhere a piece may occur in several products, so that the slope of an
/// R-function is not 1 there. Throws as above, if a piece does not bound the solid all along, and
/// as `WindingSign`.
DescribedSolid described_solid(const std::vector<ThinSet>& pieces,
                               const std::vector<std::string>& names);

}  // namespace rfm
