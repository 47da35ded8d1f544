#pragma once

#include <optional>

#include "core/thin_set.hpp"
#include "problems/output/canvas.hpp"
#include "problems/pictures/camera.hpp"
#include "problems/pictures/scene_samples.hpp"

namespace rfm {

/// Where a name may stand, and how much of the set is seen.
struct SetPlace {
  PixelPosition place;
  int seen_pixels = 0;
};

/// Paints a set over a view of a body whose upper left corner is at pixel (left, top) of a canvas:
/// points as disks, segments, chains and the edges of triangles as lines, paler where the body
/// hides them; of a surface given by a formula the line in which it meets what is seen. Nothing if
/// none of it is in the picture.
std::optional<SetPlace> paint_set(Canvas& canvas, double left, double top,
                                  const SceneSamples& scene, const Camera& camera,
                                  const ThinSet& set, const Colour& colour, double line_width);

}  // namespace rfm
