#pragma once

#include <vector>

#include "core/thin_set.hpp"
#include "problems/output/pixel_window.hpp"

namespace rfm {

/// How far the centre of each pixel is from a set of the plane, in pixels; infinite beyond `reach`
/// pixels. Of points, segments and chains exact; of others to first order, by their function.
std::vector<float> distances_from(const ThinSet& set, const PixelWindow& window, double reach);

}  // namespace rfm
