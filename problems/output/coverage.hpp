#pragma once

#include <span>
#include <vector>

namespace rfm {

/// A position on an image in pixels: x to the right, y down, whole numbers between pixels.
struct PixelPosition {
  double x = 0, y = 0;
};

/// How much of each pixel a shape covers, 0 to 1, in the rectangle of pixels
/// [left, left + width) × [top, top + height).
struct Coverage {
  int left = 0, top = 0, width = 0, height = 0;
  std::vector<float> amount;  ///< row by row

  float at(int x, int y) const {
    return amount[static_cast<std::size_t>(y - top) * width + (x - left)];
  }
};

/// The area of each pixel within a polygon, exact up to rounding, cut to an image of
/// `image_width` × `image_height` pixels. Corners may run either way; where a polygon crosses
/// itself so that parts run in opposite directions, these cancel.
Coverage polygon_coverage(std::span<const PixelPosition> corners, int image_width,
                          int image_height);

/// A line of `line_width` pixels along a polyline, with round joints and ends: across a straight
/// line the coverage is that of a box filter one pixel wide, so that it sums to the width of the
/// line, thin lines (below one pixel) included.
Coverage line_coverage(std::span<const PixelPosition> points, double line_width, int image_width,
                       int image_height);

}  // namespace rfm
