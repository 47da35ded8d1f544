#pragma once

#include "problems/output/image.hpp"
#include "problems/scalar_problem.hpp"

namespace rfm {

/// The picture of `check` for a domain on the line, see `draw_check`.
Image draw_line_check(const ScalarProblem& problem, const Grid& grid, int width);

}  // namespace rfm
