#pragma once

#include <vector>

#include "solution_structures/structure.hpp"
#include "solvers/discretized_region.hpp"
#include "solvers/integrand.hpp"
#include "solvers/linear_solver.hpp"

namespace rfm {

struct RitzSolution {
  Field u;                ///< a field like any other
  LinearSolution linear;  ///< the coefficients, and how well they were found
};

/// W. Ritz's method: of all functions of the form `structure`, with Ψ a spline on the grid of
/// `domain`, the one for which the energy Σ ∫ (½ dᵀ C d − bᵀ d) is stationary (least, if C is
/// positive).
///
///     const RitzSolution solution = minimize({heat}, dirichlet(g, omega), domain);
///
/// One unknown and one undetermined function; systems are put together by `assemble` and `solve`
/// themselves. Throws `ComputationError` if the energy does not determine the solution, and
/// `InvalidArgument` if the structure uses more than one undetermined function.
RitzSolution minimize(const std::vector<Contribution>& energy, const Structure& structure,
                      const DiscretizedRegion& domain);

}  // namespace rfm
