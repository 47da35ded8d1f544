#pragma once

#include "problems/output/colour_bar.hpp"
#include "problems/pictures/camera.hpp"

namespace rfm {

/// Several views of one scale in a rectangle of a picture, each with a line of text above it.
struct PanelArrangement {
  int columns = 1, rows = 1;
  /// Height over width of all of them together.
  double aspect = 1;

  /// For `count` views of a window: side by side, unless it is so flat that they are larger one
  /// above the other.
  static PanelArrangement of(const ViewWindow& window, int count);
  /// The room of view `number` within the whole, on whole pixels, without the line above it.
  PixelRectangle place(int number, const PixelRectangle& whole, double font_size) const;
};

}  // namespace rfm
