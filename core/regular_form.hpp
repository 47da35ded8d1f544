#pragma once

#include <optional>

#include "core/region.hpp"

namespace rfm {

/// Another expression of the same solid by the same primitives, without zeros inside: a product of
/// sums, as short as can be found, for weights, in which each primitive should occur once and no
/// two coincide. Looked for where the region has zeros inside, or two of its primitives vanish on
/// the same set, as the sides of boxes that are flush; nothing otherwise, where the primitives do
/// not describe such an expression (three disks through one point), where `same_solid` does not
/// prove that it is the same, or with more than 16 primitives.
std::optional<BooleanExpression> regular_form(const RegionEvaluator& region, const Box& bounds);

}  // namespace rfm
