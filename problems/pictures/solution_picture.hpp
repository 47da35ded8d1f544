#pragma once

#include "problems/output/image.hpp"
#include "problems/pictures/shown_field.hpp"

namespace rfm {

/// Draws a result of a solved problem as `picture` asks: in 2D colours with contour lines, or
/// arrows for a vector; in 1D a plot over x; in 3D the body, whole and cut open. Needs no display.
///
/// `remarks` receives what the viewer should know: values that are not finite, contour lines that
/// could not be drawn.
Image draw_solution(const ScalarProblem& problem, const ScalarSolution& solution,
                    const Picture& picture, std::vector<std::string>& remarks);
/// The same for a field that need not be the one that `picture` names.
Image draw_shown(const ScalarProblem& problem, const ShownField& shown, const Picture& picture,
                 std::vector<std::string>& remarks);

}  // namespace rfm
