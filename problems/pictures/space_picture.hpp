#pragma once

#include "problems/pictures/shown_field.hpp"

namespace rfm {

/// A field on a body in space, without a mesh and without a graphics library: rays find the surface
/// and its true normals, and the field is evaluated where they hit. Two views of one scale, side by
/// side or one above the other: the whole body, and the body cut open, where the colours of the cut
/// face are exactly those of the colour bar. Contour lines, thin lines along edges and silhouettes,
/// a triad of axes. Of a vector the length is shown.
Image draw_space(const ScalarProblem& problem, const ShownField& shown, const Picture& picture,
                 std::vector<std::string>& remarks);

}  // namespace rfm
