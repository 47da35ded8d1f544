#pragma once

#include <memory>
#include <optional>

#include "quadrature/active_set.hpp"

namespace rfm {

/// A box of the plane seen from a frame in which its curves are graphs over one axis, although they
/// are so over no axis of the world: the bounding box in the frame, with the four sides of the
/// original box as further conditions.
class RotatedBox {
 public:
  /// The frame whose height direction comes nearest to the gradients at the centre of the box.
  /// Nothing if no frame is promising, if fewer than two curves meet (a singular point of one curve
  /// gains nothing by rotation), or if a curve is parallel to an axis (it might lie on a side).
  static std::optional<RotatedBox> around(const Box& box, const ActiveSet& active);

  const Frame& frame() const { return parts_->frame; }
  const Box& box() const { return box_; }
  const ActiveSet& active() const { return active_; }
  /// A curve touches a side of the original box within rounding. In the world the boxes on both
  /// sides see the same curve there; turned, each rounds for itself.
  bool touches_side() const { return touches_side_; }

 private:
  struct Parts {
    Frame frame;
    std::vector<Surface> surfaces;
  };
  std::unique_ptr<const Parts> parts_;
  Box box_;
  ActiveSet active_;
  bool touches_side_ = false;
};

}  // namespace rfm
