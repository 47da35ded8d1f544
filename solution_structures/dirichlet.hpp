#pragma once

#include "core/field.hpp"
#include "solution_structures/structure.hpp"

namespace rfm {

/// u = g + ω Ψ: equal to g wherever ω = 0, for every Ψ; the structure of L. V. Kantorovich and
/// V. L. Rvachev. It is complete where u − g = O(ω), that is where ω vanishes to first order on the
/// prescribed part of the boundary and nowhere else in the closed region.
Structure dirichlet(const Field& g, const Field& omega);

}  // namespace rfm
