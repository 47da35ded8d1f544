#pragma once

#include <string>

#include "problems/output/colour_bar.hpp"
#include "problems/output/ticks.hpp"

namespace rfm {

/// One direction of a plot: a range of values and the round numbers along it.
struct Axis {
  double low = 0, high = 1;
  bool logarithmic = false;
  Ticks ticks;
  std::string title;

  /// Position of a value along the axis, 0 at low and 1 at high.
  double share(double value) const;

  /// An axis with a tick about every `spacing` of its `length` pixels. Throw `InvalidArgument` as
  /// `nice_ticks` and `decade_ticks` do.
  static Axis linear(double low, double high, double length, double spacing);
  static Axis decades(double low, double high);
};

/// Two axes around a rectangle of an image; y upwards.
struct Axes {
  PixelRectangle frame;
  Axis x, y;
  double font_size = 16;

  PixelPosition place(double x_value, double y_value) const {
    return {frame.left + x.share(x_value) * frame.width,
            frame.bottom() - y.share(y_value) * frame.height};
  }
  /// Light lines at the ticks, to be drawn before what is plotted.
  void draw_grid(Canvas& canvas) const;
  /// The frame, ticks, numbers and titles.
  void draw(Canvas& canvas) const;
};

/// Pixels that the numbers (and the title) of an axis need, left of the frame and below it.
double left_margin(const Axis& y, double font_size);
double bottom_margin(const Axis& x, double font_size);

}  // namespace rfm
