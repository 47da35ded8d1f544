#pragma once

#include "problems/output/image.hpp"
#include "problems/scalar_problem.hpp"

namespace rfm {

/// The picture of `check` for a domain in the plane, see `draw_check`.
Image draw_plane_check(const ScalarProblem& problem, const DomainRule& rule, int width);

/// "hole: convection", as legends and reports say it.
std::string description(const PieceCondition& condition);

}  // namespace rfm
