#pragma once

#include "problems/output/image.hpp"
#include "problems/scalar_problem.hpp"

namespace rfm {

/// The picture of `check` for a body in space: seen from the front, from the opposite side and cut
/// open, each piece of its boundary in a colour with its name where it is seen, the box of the grid
/// with its lines behind; a legend says which condition each piece has.
Image draw_space_check(const ScalarProblem& problem, const DomainRule& rule, int width);

}  // namespace rfm
