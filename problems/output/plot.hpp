#pragma once

#include <string>
#include <vector>

#include "problems/output/axes.hpp"

namespace rfm {

/// A value y over x in the coordinates of a plot.
struct PlotPoint {
  double x = 0, y = 0;
};

/// A curve of a plot, in parts that are not joined to each other.
struct PlotCurve {
  std::vector<std::vector<PlotPoint>> parts;
  Colour colour = black;
  double line_width = 2;
  bool has_markers = false;
  /// Written beside the last point, if any; with a right margin, outside of the frame.
  std::string label;
  Align label_side = Align::after;
  double label_below = 0;  ///< lower by so many heights of the font
};

/// A straight piece in a plot with a text, as the slope of a curve.
struct PlotTriangle {
  /// The corner at the right angle, and the two others along x and along y.
  PlotPoint corner, along_x, along_y;
  std::string label;  ///< beside the side along y
};

struct Plot {
  std::string title;
  int width = 1000;
  double aspect = 0.62;  ///< height over width of the frame
  Axis x, y;
  std::vector<PlotCurve> curves;
  std::vector<PlotTriangle> triangles;
  /// Pixels that labels need at the right of the frame.
  double right_margin = 0;
};

/// Draws axes with grid lines, curves, markers and labels; what lies beyond the axes is cut off at
/// the frame.
Image draw_plot(const Plot& plot);

/// Colours that are told apart easily, dark enough for lines on white, in turn.
Colour distinct_colour(int number);

}  // namespace rfm
