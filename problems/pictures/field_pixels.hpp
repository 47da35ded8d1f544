#pragma once

#include "core/field.hpp"
#include "problems/output/field_picture.hpp"

namespace rfm {

/// What a picture of a field is made of, beside the field.
struct FieldSampling {
  PixelWindow window;
  /// Where the field may be evaluated: pixels on the boundary whose centres lie outside are taken
  /// from here.
  Box bounds;
  /// Whether contour lines are wanted: they need ∇.
  bool with_slope = true;
};

/// Evaluates a scalar (one component) or the length of a vector at the centre of every pixel that
/// meets the region, without a mesh, in parallel. Where a pixel on the boundary has no finite value
/// it gets that of a neighbour inside; elsewhere such values stay NaN.
FieldPicture sample_field(const std::vector<Field>& components, RegionPixels region,
                          const FieldSampling& sampling);

}  // namespace rfm
