#pragma once

#include <string>
#include <utility>
#include <vector>

#include "problems/scalar_problem.hpp"

namespace rfm {

/// The function ω of the domain: R-functions of the rule of combination, R₀ where that is no
/// system.
Field domain_function(const ScalarProblem& problem);

/// How near a function ω that vanishes on pieces of the boundary is to a distance: for each of the
/// primitives `pieces` the largest deviation of |∇ω| from 1 over the points of the rule. Where ∇ω
/// does not exist on the boundary, since a piece occurs several times in ω, it is the limit from
/// inside. Pieces without points are left out.
std::vector<std::pair<std::string, double>> distance_quality(const Field& omega,
                                                             const ScalarProblem& problem,
                                                             const DomainRule& rule,
                                                             const std::vector<int>& pieces);

}  // namespace rfm
