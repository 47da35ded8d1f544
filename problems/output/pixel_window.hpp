#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/box.hpp"
#include "problems/output/coverage.hpp"

namespace rfm {

/// Square pixels laid over a rectangle of the plane. Pixels are counted from the upper left corner,
/// rows downwards, while y grows upwards.
struct PixelWindow {
  int width = 0, height = 0;  ///< in pixels
  double left = 0, top = 0;   ///< coordinates of the upper left corner
  double pixel_size = 1;      ///< side of a pixel in the plane

  /// The smallest window of this shape that shows `box`, centred on it.
  static PixelWindow around(const Box& box, int width, int height);

  int pixel_count() const { return width * height; }
  Point centre(int x, int y) const {
    return {left + (x + 0.5) * pixel_size, top - (y + 0.5) * pixel_size, 0};
  }
  /// Where a point of the plane is on the picture, from the window's corner.
  PixelPosition place(const Point& point) const {
    return {(point[0] - left) / pixel_size, (top - point[1]) / pixel_size};
  }
  double right() const { return left + width * pixel_size; }
  double bottom() const { return top - height * pixel_size; }
};

inline PixelWindow PixelWindow::around(const Box& box, int width, int height) {
  const double size = std::max(box.length(0) / width, box.length(1) / height);
  const Point center = box.center();
  return {width, height, center[0] - 0.5 * width * size, center[1] + 0.5 * height * size, size};
}

/// The region as pixels see it.
struct RegionPixels {
  /// Distance of the pixel's centre from the boundary in pixels, to first order; positive inside.
  /// Infinite where it is farther than the few pixels that drawing needs.
  std::vector<float> distance;
  /// The primitive on whose boundary the nearest point lies; −1 where the distance is infinite.
  std::vector<int> primitive;

  /// The part of a pixel that lies inside: exact for a straight boundary along the axes.
  double covered(std::size_t pixel) const { return std::clamp(distance[pixel] + 0.5, 0.0, 1.0); }
  /// The part of a pixel on a line of this width along the boundary.
  double on_line(std::size_t pixel, double line_width) const {
    return std::clamp(0.5 * (line_width + 1) - std::abs(distance[pixel]), 0.0,
                      std::min(1.0, line_width));
  }
};

}  // namespace rfm
