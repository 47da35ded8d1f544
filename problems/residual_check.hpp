#pragma once

#include <span>

#include "problems/scalar_problem.hpp"

namespace rfm {

/// Adds a warning for each residual of the user's own of which a tenth or more is left, in L2 over
/// the domain, of what it is at `start`, where all undetermined functions are zero: equations that
/// contradict each other or the conditions, as div u = 1 between walls, have a least sum of squares
/// like any others.
void warn_of_residuals(const ScalarProblem& problem, std::span<const Field> start,
                       ScalarSolution& solution);

}  // namespace rfm
