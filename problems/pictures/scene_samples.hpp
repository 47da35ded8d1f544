#pragma once

#include <limits>
#include <vector>

#include "problems/pictures/camera.hpp"
#include "quadrature/ray_caster.hpp"

namespace rfm {

/// What is seen at one place of a picture.
struct SceneSample {
  static constexpr int nothing = -2;
  Point point{};
  Point normal{};
  int primitive = nothing;
  /// Of the field that is shown; NaN where there is none.
  double value = std::numeric_limits<double>::quiet_NaN();

  bool is_surface() const { return primitive != nothing; }
};

/// A region as the pixels of a camera see it: one ray through the middle of each pixel; where what
/// is seen changes (edges, silhouettes) there are `side` × `side` rays a pixel.
struct SceneSamples {
  static constexpr int side = 3, per_block = side * side, middle = per_block / 2;
  int width = 0, height = 0;
  double pixel_size = 1;
  std::vector<SceneSample> centres;  ///< pixel by pixel, row by row from the top
  std::vector<int> block;            ///< of each pixel: the number of its block, or −1
  std::vector<SceneSample> blocks;   ///< `per_block` samples each, row by row

  const SceneSample& centre(int x, int y) const { return centres[index(x, y)]; }
  std::size_t index(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
           static_cast<std::size_t>(x);
  }
  /// A sample by its place on the grid of `side` · width by `side` · height; that of the middle
  /// where a pixel has only one, nothing beyond the picture.
  const SceneSample& fine(int x, int y) const;
};

/// What lies between two samples next to each other.
enum class Step { none, crease, jump };
/// `jump`: one is in front of the other, or of the background. `crease`: another primitive, or a
/// sharp turn of the normal.
Step step_between(const SceneSample& a, const SceneSample& b, double pixel_size);

/// In parallel; the result does not depend on the number of threads.
SceneSamples sample_scene(const RayCaster& rays, const Camera& camera);

/// What of the plane of a view the region covers, to about a hundredth of its width; the projection
/// of the bounds where no ray hits.
ViewWindow seen_window(const RayCaster& rays, const View& view, const Box& bounds);

}  // namespace rfm
