#pragma once

#include "problems/output/image.hpp"
#include "problems/scalar_problem.hpp"

namespace rfm {

/// Draws what `check` reports. In 2D: the domain, each piece of its boundary in a colour with its
/// name, the grid with cells inside and cut cells told apart, level lines of the region's function
/// ω (R₀-functions over its primitives); a legend says which condition each piece has. In 1D: ω
/// over x with the grid and the named ends. In 3D: three views of the body with its pieces in
/// colours. Where the file asks for the points of the rule (`outputs.rule`), a dot for each: in 3D
/// for those of the boundary that are seen. Needs no display.
Image draw_check(const ScalarProblem& problem, const DomainRule& rule, int width);

}  // namespace rfm
