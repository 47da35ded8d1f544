#pragma once

#include <optional>

#include "core/region.hpp"

namespace rfm {

/// Whether two expressions of the primitives of a region are the same set up to boundaries: proved
/// wherever the signs of both are proved in boxes of 2⁻⁸ of the longest side (2⁻⁵ in space).
bool same_solid(const BooleanExpression& a, const BooleanExpression& b,
                const RegionEvaluator& region, const Box& bounds);

/// Another expression of the same solid by the same primitives, without zeros inside: a product of
/// sums, as short as can be found, for weights, in which each primitive should occur once and no
/// two coincide. Looked for where the region has zeros inside, or two of its primitives vanish on
/// the same set, as the sides of boxes that are flush; nothing otherwise, where the primitives do
/// not describe such an expression (three disks through one point), or with more than 16
/// primitives.
std::optional<BooleanExpression> regular_form(const RegionEvaluator& region, const Box& bounds);

}  // namespace rfm
