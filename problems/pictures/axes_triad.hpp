#pragma once

#include "problems/output/canvas.hpp"
#include "problems/pictures/camera.hpp"

namespace rfm {

/// Draws the directions of x, y and z as a viewer sees them: three arrows of `size` pixels from
/// `origin`, those that point away from the viewer first, with their letters.
void draw_axes_triad(Canvas& canvas, const PixelPosition& origin, double size, double font_size,
                     const View& view);

}  // namespace rfm
