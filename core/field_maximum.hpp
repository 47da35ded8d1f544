#pragma once

#include "core/region.hpp"

namespace rfm {

struct FieldMaximumOptions {
  /// Boxes are divided until bounds leave so much above the value found, as a part of the largest
  /// value over the bounds.
  double tolerance = 1e-9;
  int most_boxes = 20000;  ///< that are looked at
};

/// The largest value of a function that was found in a region, and what it is at most (proved).
struct FieldMaximum {
  double value = 0;
  Point at{};
  double at_most = 0;
  int boxes = 0;
};

/// max f over the part of a region within `bounds`, by branch and bound on the bounds of f, the
/// most promising box first; `start` is a point of the region with a value that is known to be
/// large. Needs no derivatives: it finds what lies on kinks, as the centre of the largest disk
/// within a polygon, where its distance is largest. There boxes halve in proportion and a few
/// hundred give nine digits; about a smooth maximum the best box is only as near as bounds are of
/// second order, and where f is largest along a whole curve `most_boxes` end the search early.
/// Boxes without a point of the region are left out only where that is proved, so that `at_most`
/// may be that of a point beyond the boundary by less than the size of the last boxes.
FieldMaximum field_maximum(const LevelFunction& f, const RegionEvaluator& region, const Box& bounds,
                           const Point& start, const FieldMaximumOptions& options = {});

/// Whether a field is a formula of coordinates, exact distances and tables alone, with bounds that
/// are quick and no solution in it.
bool is_geometric(const Field& f);

}  // namespace rfm
