#pragma once

#include <string>
#include <vector>

#include "problems/output/image.hpp"
#include "problems/scalar_problem.hpp"

namespace rfm {

/// The first modes of an eigenproblem, at most twelve, side by side with their eigenvalues, each in
/// colours symmetric about zero, of vectors the length with arrows; in all else as `picture` says.
/// `remarks` as in `draw_solution`.
Image draw_modes(const ScalarProblem& problem, const ScalarSolution& solution,
                 const Picture& picture, std::vector<std::string>& remarks);

}  // namespace rfm
