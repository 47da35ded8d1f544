#pragma once

#include <vector>

#include "core/region.hpp"
#include "problems/problem.hpp"
#include "solvers/form.hpp"

namespace rfm {

/// The forms of `physics: {type: custom}`: the one of the volume first, then those of the boundary,
/// piece by piece of the primitives that bound the domain. Energies may be asked for without their
/// loads (solvers/form_loads.hpp).
std::vector<Form> custom_forms(const Problem& problem, const RegionEvaluator& region,
                               const std::vector<int>& bounding_primitives, bool with_loads = true);

}  // namespace rfm
