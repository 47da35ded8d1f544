#pragma once

#include <functional>

#include "problems/output/canvas.hpp"
#include "problems/pictures/scene_samples.hpp"

namespace rfm {

struct SceneStyle {
  /// The colour of a surface before light falls on it.
  std::function<Colour(const SceneSample&)> colour;
  /// The primitive of a cut face: it is not shaded, so that its colours are those of the scale.
  int flat_primitive = SceneSample::nothing;
  /// Lines where the value is a multiple of this; 0: none.
  double contour_step = 0;
  double contour_width = 1.2;  ///< in pixels
};

/// Paints samples with their upper left corner at pixel (left, top) of a canvas: surfaces in the
/// light of two lamps beside the viewer, contour lines, and thin lines along silhouettes and,
/// paler, creases between primitives. The background remains what it is.
void paint_scene(Canvas& canvas, int left, int top, const SceneSamples& scene, const Camera& camera,
                 const SceneStyle& style);

}  // namespace rfm
