#pragma once

#include <string>
#include <vector>

#include "problems/output/canvas.hpp"
#include "problems/output/colour_map.hpp"

namespace rfm {

/// A rectangle of an image, in pixels.
struct PixelRectangle {
  double left = 0, top = 0, width = 0, height = 0;
  double right() const { return left + width; }
  double bottom() const { return top + height; }
};

struct ColourBarStyle {
  double font_size = 16;
  /// Above the bar: what the colours mean.
  std::string title;
  /// Marked across the bar: the levels of contour lines.
  std::vector<double> levels;
};

/// Draws a vertical bar with the colours of `scale`, low below, and round numbers at its right.
void draw_colour_bar(Canvas& canvas, const PixelRectangle& bar, const ColourScale& scale,
                     const ColourBarStyle& style);

/// Pixels to the right of a bar that its numbers need, however high it is.
double colour_bar_label_width(const ColourScale& scale, double font_size);

}  // namespace rfm
