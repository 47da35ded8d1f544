#pragma once

#include "core/region.hpp"

namespace rfm {

/// Whether bounds prove a function finite and smooth in the whole closed region: branch and bound
/// down to 1/64 of `bounds`. A jump or a kink of data would run through the whole domain with a
/// structure. A function that is merely undefined somewhere (√ of a negative number) may pass;
/// its values tell.
bool is_regular(const Field& function, const RegionEvaluator& region, const Box& bounds);

}  // namespace rfm
