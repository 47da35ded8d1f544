#pragma once

#include <string>
#include <vector>

#include "problems/result_folder.hpp"
#include "problems/verification.hpp"

namespace rfm {

/// Adds NAME.png, the picture that `outputs.picture` asks for (or of u), to a result, of an
/// eigenproblem NAME.modes.png with its first modes, and after a convergence study
/// NAME.convergence.png. Returns what is to be said of them: where there is
/// nothing to see, and why.
std::vector<std::string> write_pictures(ResultFolder& folder, const std::string& name,
                                        const ScalarProblem& problem,
                                        const ScalarSolution& solution,
                                        const std::vector<ConvergenceRow>& convergence);

}  // namespace rfm
