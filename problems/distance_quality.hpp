#pragma once

#include <string>
#include <utility>
#include <vector>

#include "problems/scalar_problem.hpp"

namespace rfm {

/// How near the function ω of the domain (R-functions of the rule of combination, R₀ where that is
/// no system) is to a distance: for each piece of the boundary the largest deviation of |∇ω| from 1
/// over the points of the rule. Rounding where all shapes are normalised and no two share a side;
/// `expression` shapes are taken as they are. Pieces without points are left out.
std::vector<std::pair<std::string, double>> distance_quality(const ScalarProblem& problem,
                                                             const DomainRule& rule);

}  // namespace rfm
