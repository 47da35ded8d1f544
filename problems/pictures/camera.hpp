#pragma once

#include "core/line.hpp"
#include "problems/output/coverage.hpp"

namespace rfm {

/// Where the viewer stands: directions to the right, up and towards the viewer are orthonormal. z
/// is up, but for a view along z, where y is.
struct View {
  Point target{};  ///< what is looked at
  Point right{}, up{}, towards{};
  double distance = 1;  ///< of the viewer from the target

  /// From the direction `towards_viewer` (of any length) at the middle of a box, from so far away
  /// that perspective is mild: 3.5 diagonals. Throws `InvalidArgument` for a direction without
  /// length.
  static View at(const Box& box, const Point& towards_viewer);

  Point eye() const;
  /// Coordinates to the right and up where the line from the eye to a point meets the plane through
  /// the target that faces the viewer.
  std::array<double, 2> project(const Point& point) const;
};

/// A rectangle of that plane, in its coordinates.
struct ViewWindow {
  double left = 0, right = 0, low = 0, high = 0;

  double width() const { return right - left; }
  double height() const { return high - low; }
  void include(const std::array<double, 2>& place);
  /// Of the corners of a box.
  static ViewWindow of(const View& view, const Box& box);
};

/// A view and the pixels it is seen in.
struct Camera {
  View view;
  int width = 0, height = 0;
  double pixel_size = 1;              ///< at the target
  double middle_x = 0, middle_y = 0;  ///< the pixel coordinates of the target

  /// Shows `window` as large as it fits, centred.
  static Camera around(const View& view, const ViewWindow& window, int width, int height);

  /// The ray of length 1 per unit of its parameter through a place of the picture.
  Line ray(double x, double y) const;
  PixelPosition place(const Point& point) const;
};

}  // namespace rfm
