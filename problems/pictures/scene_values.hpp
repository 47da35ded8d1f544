#pragma once

#include "core/field.hpp"
#include "problems/output/colour_map.hpp"
#include "problems/pictures/scene_samples.hpp"

namespace rfm {

/// Evaluates a scalar (one component) or the length of a vector at every sample that shows a
/// surface, in parallel. Points are kept within `bounds`, where the field may be evaluated; where
/// it has no finite value on the surface, that 10⁻⁶ of the size further inside is taken, else NaN.
/// Returns the range of the finite values; low > high if there are none.
ValueRange evaluate_on(SceneSamples& scene, const std::vector<Field>& components,
                       const Box& bounds);

}  // namespace rfm
