#pragma once

#include "core/region.hpp"

namespace rfm {

/// Whether bounds prove a function finite in the whole closed region: branch and bound down to 1/64
/// of `bounds`. A function that is merely undefined somewhere (√ of a negative number) may pass; its
/// values tell.
bool is_bounded(const Field& function, const RegionEvaluator& region, const Box& bounds);

}  // namespace rfm
