#pragma once

#include "core/grid.hpp"
#include "problems/output/canvas.hpp"
#include "problems/pictures/camera.hpp"

namespace rfm {

/// Draws the three faces of a grid's box that look towards the viewer from inside, with the grid's
/// lines on them (every second, fifth, tenth … where they would be nearer than about four pixels):
/// what stands behind a body. `left` and `top` are the upper left corner of the camera's picture.
void draw_grid_box(Canvas& canvas, double left, double top, const Camera& camera, const Grid& grid);

}  // namespace rfm
