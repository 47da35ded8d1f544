#pragma once

#include <optional>
#include <vector>

#include "core/region.hpp"
#include "quadrature/domain_rule.hpp"

namespace rfm {

struct Extreme {
  double value = 0;
  Point at{};
};

/// The largest value of a field over a region or, without `primitives`, over its boundary and
/// inside: the best point of `rule`, improved by Newton's method on the conditions of Lagrange
/// (solvers/stationary_point.hpp) inside, on every piece of the boundary near it, and where pieces
/// meet. What comes out is a value of the field at a point of the region; it is the maximum, to
/// rounding, where the field is twice differentiable and the points of the rule are close enough to
/// see which maximum is the largest. Inside, a field without a solution in it, as
/// a distance, which has kinks, is searched by branch and bound as well (core/field_maximum.hpp),
/// which needs neither. Throw `ComputationError` where the rule has no points.
Extreme maximum_over_volume(const Field& f, const RegionEvaluator& region, const DomainRule& rule);

/// The largest value over pieces of the boundary, where `where` is ≥ 0.
Extreme maximum_over_boundary(const Field& f, const RegionEvaluator& region, const DomainRule& rule,
                              const std::vector<int>& primitives,
                              const std::optional<Field>& where = {});

}  // namespace rfm
