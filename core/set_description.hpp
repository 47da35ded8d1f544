#pragma once

#include <functional>
#include <optional>
#include <utility>
#include <vector>

#include "core/boolean_minimization.hpp"
#include "core/region.hpp"

namespace rfm {

/// Whether a point belongs to a solid set: `unknown` on its boundary.
using Membership = std::function<Truth(const Point&)>;

/// A region as a solid: the closure of its interior. Points with inside all around belong to it.
Membership solid_membership(const RegionEvaluator& region);

/// What a solid is in terms of the signs of given primitives (half-spaces): the inverse problem of
/// analytic geometry by sampling (V. Shapiro, Acta Numerica 16 (2007), §5.3).
///
/// One point is kept of every combination of signs that is found: in boxes halved towards the zero
/// sets of the primitives (2⁻⁷ of the longest side of twice the bounds, 2⁻⁵ in space), on both
/// sides of zeros near those boxes, around common zeros, and far away. Points on zero sets and
/// common zeros are kept as well, with zero for a sign: closed products of half-spaces hold them.
/// Cells that no such point meets may be missed; `same_solid` (core/same_solid.hpp) finds out.
/// Where points of the pieces of the boundary are given, boxes next to a piece are halved to an
/// eighth of its size (a quarter in space), and points are taken on both sides of those given, from
/// a tenth to 10⁻⁷ of its size away.
class SetDescription {
 public:
  struct Sample {
    Point point;
    Cube signs;
    bool inside;
  };

  /// Bounds must hold the solid, or its complement. `pieces` are points of each piece of the
  /// boundary, where they are known.
  SetDescription(const std::vector<Field>& primitives, const Membership& membership,
                 const Box& bounds, const std::vector<std::vector<Point>>& pieces = {});

  const std::vector<Sample>& samples() const { return samples_; }
  /// The same solid by some of the primitives only, the others unused.
  SetDescription restricted(const std::vector<bool>& used) const;
  /// The pseudo-complement: closure of the outside.
  SetDescription complement() const;

  /// A point of the solid and one outside of it that the signs of the primitives do not tell apart
  /// (the second may lie on the boundary of the cell of the first): then no Boolean expression of
  /// the primitives is the solid (theorem 5), and separators between the two are needed. Nothing if
  /// the solid is describable.
  std::optional<std::pair<Point, Point>> conflict() const;

  /// The canonical disjunctive form (5.4): one product of all primitives for each cell inside.
  /// Throws `InvalidArgument` if the solid is not describable.
  BooleanExpression canonical_form() const;
  /// As few and as short products as can be found; combinations of signs that do not occur are
  /// don't-cares, and zeros inside are covered where that is possible. Throws as `canonical_form`.
  BooleanExpression minimal_form() const;

 private:
  SetDescription() = default;
  /// Whether a sample lies in the interior of a cell of the primitives that are used.
  bool is_in_a_cell(const Sample& sample) const;
  void require_describable() const;

  std::vector<bool> used_;
  int dimension_ = 2;
  std::vector<Sample> samples_;
};

/// Which primitives remain when those from number `first_separator` on are removed one by one, as
/// long as the solid stays describable: a minimal, not unique, set of separators (theorem 6).
/// Throws `InvalidArgument` if it is not describable with all of them.
std::vector<bool> without_needless_separators(const SetDescription& description,
                                              int first_separator);

}  // namespace rfm
