#pragma once

#include "problems/output/axes.hpp"
#include "problems/output/pixel_window.hpp"
#include "problems/pictures/shown_field.hpp"

namespace rfm {

/// A field over a plane domain, evaluated at every pixel: colours, contour lines or arrows, the
/// boundary, axes with the coordinates, a colour bar and the title; both axes have one scale.
Image draw_plane(const ScalarProblem& problem, const ShownField& shown, const Picture& picture,
                 std::vector<std::string>& remarks);

/// A box with a margin around it, so that lines on its sides are seen as a whole.
Box with_margin(const Box& bounds);

/// The materials that are regions of their own.
std::vector<RegionPixels> sample_materials(const Problem& problem, const PixelWindow& window);

/// Sets the ranges of axes to those of a window: its pixels are square, so that it shows a little
/// more along one axis than the box that it was made for.
void show_window(Axis& x, Axis& y, const PixelWindow& window);

}  // namespace rfm
