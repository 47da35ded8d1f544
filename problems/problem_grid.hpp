#pragma once

#include <optional>

#include "core/grid.hpp"
#include "problems/problem.hpp"

namespace rfm {

/// The background grid of a problem: `cells` along the longest side where given, else as the file
/// says (`discretization.grid`, `.basis.cells`, `.basis.size`, `.basis.knots`, whose lists are
/// divided by `cells` into equal parts as near to that number as may be); for functions of the
/// whole domain, which are only integrated on it, as many cells as they have turns.
Grid problem_grid(const Problem& problem, const Box& bounds, std::optional<int> cells = {});

}  // namespace rfm
