#pragma once

#include <memory>
#include <optional>
#include <string>

#include "core/region.hpp"
#include "problems/pictures/scene_samples.hpp"

namespace rfm {

/// A plane through `point`: what lies on the side that `normal` points to is taken away.
struct CutPlane {
  Point point{};
  Point normal{};

  /// Through the middle of a box, across the axis that comes nearest to the direction towards the
  /// viewer, so that the viewer looks onto the cut.
  static CutPlane facing(const Box& box, const Point& towards_viewer);
  /// "x = 0.5", or the equation of a plane that is not across an axis.
  std::string equation() const;
};

/// One view of a body, whole or cut open. Keeps what rays need between the steps of a picture.
class ScenePanel {
 public:
  /// Throws `InvalidArgument` if the plane's normal has no length.
  ScenePanel(const Region& region, const Box& bounds, const std::optional<CutPlane>& cut,
             const View& view);

  const View& view() const { return view_; }
  const RegionEvaluator& region() const { return *region_; }
  /// The number of the cut face among the primitives; `SceneSample::nothing` without a cut.
  int cut_primitive() const { return cut_primitive_; }
  /// What is seen of the region.
  ViewWindow window() const;
  /// Looks through `width` × `height` pixels at a part of the view.
  void sample(const ViewWindow& window, int width, int height);

  const Camera& camera() const { return camera_; }
  const SceneSamples& samples() const { return samples_; }
  SceneSamples& samples() { return samples_; }

 private:
  Box bounds_;
  View view_;
  int cut_primitive_ = SceneSample::nothing;
  std::unique_ptr<const RegionEvaluator> region_;
  RayCaster rays_;
  Camera camera_;
  SceneSamples samples_;
};

}  // namespace rfm
