#pragma once

#include <optional>

#include "core/region.hpp"

namespace rfm {

// Relations of points and regions, decided by branch and bound on the bounds of primitives: what is
// answered with yes or no is proved.

/// Whether a point lies inside (yes), outside (no), or within `tolerance` (a distance to first
/// order) of where that changes (unknown), 0 included: a point on the boundary to rounding is
/// unknown.
Truth membership(const RegionEvaluator& region, const Point& point, double tolerance = 1e-12);

struct RelationOptions {
  /// Boxes are divided down to this fraction of the longest side of `bounds`; what is then
  /// undecided remains so.
  double resolution = 1e-5;
  /// And at most so many are looked at.
  int most_boxes = 200000;
};

struct Relation {
  /// Yes with a witness, no with proof, or unknown at the resolution.
  Truth answer = Truth::unknown;
  /// A point that the question asks for.
  std::optional<Point> witness;
  /// An undecided box, where the answer is unknown.
  std::optional<Box> undecided;
  int boxes = 0;  ///< looked at
};

/// Whether a region has any point in `bounds`.
Relation has_points(const RegionEvaluator& region, const Box& bounds,
                    const RelationOptions& options = {});

/// Whether two regions (closed sets) share a point in `bounds`: collision. The witness lies in
/// both. Regions that touch without overlapping remain unknown, but for faces that both share
/// exactly. Throws `InvalidArgument` if they differ in dimension.
Relation intersects(const Region& a, const Region& b, const Box& bounds,
                    const RelationOptions& options = {});

/// Whether `inner` lies in `outer`, as far as `bounds` reaches; the witness of a no is a point of
/// `inner` outside `outer`. Boundaries that touch from within remain unknown, unless they are the
/// same primitive.
Relation lies_in(const Region& inner, const Region& outer, const Box& bounds,
                 const RelationOptions& options = {});

/// The distance between two regions: proved bounds, and the pair of points that attains the upper
/// one.
struct RegionDistance {
  Interval distance;
  Point first{}, second{};  ///< in the first and in the second region
  int pairs = 0;            ///< of boxes, looked at
};

/// min |p − q| over p in a, q in b (compact regions, with their bounding boxes). Pairs of boxes are
/// divided, the nearest first, until the bounds are `tolerance` apart (an absolute length) or
/// `most_pairs` were looked at (more if none of them showed a point of both). The upper bound comes
/// from a local search and is right to rounding as soon as its place is found; the lower one from
/// multipliers (core/shortest_way.hpp), which prove an isolated minimum on boxes that are as large
/// as curvatures allow. Where points of a whole curve are equally near, the number of pairs grows
/// as tolerance^(−1/3). Throws `InvalidArgument` if one of the regions is empty, if no points of
/// both are found, or if they differ in dimension.
RegionDistance distance_between(const RegionEvaluator& a, const Box& bounds_a,
                                const RegionEvaluator& b, const Box& bounds_b, double tolerance,
                                int most_pairs = 400000);

}  // namespace rfm
