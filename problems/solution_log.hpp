#pragma once

#include "problems/run_log.hpp"
#include "problems/scalar_problem.hpp"

namespace rfm {

/// Tells of a solution what its user should see: the structure, the grid, how exact the quadrature
/// is, how equations were solved and how well they hold, and notes of all that may be wrong.
void log_solution(RunLog& log, const ScalarProblem& problem, const Grid& grid,
                  const ScalarSolution& solution);

}  // namespace rfm
