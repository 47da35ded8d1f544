#pragma once

#include "problems/pictures/shown_field.hpp"

namespace rfm {

/// A field over a plane domain, evaluated at every pixel: colours, contour lines or arrows, the
/// boundary, axes with the coordinates, a colour bar and the title; both axes have one scale.
Image draw_plane(const ScalarProblem& problem, const ShownField& shown, const Picture& picture,
                 std::vector<std::string>& remarks);

/// The window that shows a domain with a margin around it, as high as its width asks.
Box with_margin(const Box& bounds);

}  // namespace rfm
