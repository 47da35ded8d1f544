#pragma once

#include <functional>
#include <memory>
#include <span>

#include "core/level_function.hpp"

namespace rfm {

/// A point, a segment or a curve near which integrands are not smooth: the corner of a region where
/// an R-function or a singular enrichment is not, the tip of a crack, an edge. Rules are graded
/// towards it: with Q_k the points within reach · ratio^k of it (in the maximum norm), boxes are
/// split at the sides of Q₀, Q₁, … Q_levels,
///
///     +-------+---+---+-------+
///     |       |   |   |       |      Q₀ the whole, Q₁ the four parts in the middle, split once
///     more
///     +-------+---+---+-------+      at the point itself, so that no Gauss point falls on it;
///     |       |   x   |       |      ratio 1/2, levels 1
///     +-------+---+---+-------+
///     |       |   |   |       |
///     +-------+---+---+-------+
///
/// so that no part is larger than its distance from the singularity. With r the distance, the error
/// of ∫ r^α f with smooth f is O(ratio^(levels · (α + c))), where c is the codimension (d for a
/// point), plus what q Gauss points leave on each part, which falls exponentially in q: with levels
/// in proportion to q convergence is exponential (C. Schwab, p- and hp-Finite Element Methods,
/// 1998, section 4.5). Needs α + c > 0.
///
/// A segment that is parallel to an axis is not split along it. Around other segments cubes are
/// halved along all axes, about 2^levels times as many parts.
///
/// A curve is where functions vanish together: one of the plane, two of space, as those of two
/// surfaces at their edge (two of the plane are points, one of space is a surface). Cubes are
/// halved wherever bounds of all of them hold zero within the size of a cube of it, so that no part
/// is larger than its distance from the curve; bounds that are not sharp cost further parts only.
struct Grading {
  Point from{};
  /// The other end; the same as `from` for a point.
  Point to{};
  int levels = 10;
  double ratio = 0.5;
  /// Where grading begins; 0 for the longest side of a cell.
  double reach = 0;
  /// The functions of a curve, instead of the point or segment.
  std::vector<std::shared_ptr<const LevelFunction>> curve = {};
};

/// A grading towards the curve on which all of `functions` vanish.
Grading towards_curve(const std::vector<Field>& functions, int dimension, int levels);

/// Whether a point is the singular point itself, or on a segment parallel to an axis, to the last
/// bit. Parts of rounding width at the tip of a wedge may leave such points, of negligible weight,
/// where an integrand is infinite.
bool lies_on(const Grading& grading, int dimension, const Point& point);

/// Throws `InvalidArgument` unless 0 ≤ levels ≤ 60, 0 < ratio < 1, reach ≥ 0, all finite.
void check(const Grading& grading);

/// Calls `visit` for the parts into which gradings split `box`, one after the other; for the box
/// itself if none reaches it. `spacing` is the reach of those that have none of their own.
void visit_graded_parts(const Box& box, std::span<const Grading> gradings, double spacing,
                        const std::function<void(const Box&)>& visit);

/// Whether one of the gradings splits `box`.
bool is_graded(const Box& box, std::span<const Grading> gradings, double spacing);

}  // namespace rfm
