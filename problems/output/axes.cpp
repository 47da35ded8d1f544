#include "problems/output/axes.hpp"

#include <algorithm>
#include <cmath>

namespace rfm {
namespace {

constexpr Colour frame_colour{0.35, 0.35, 0.35};
constexpr Colour grid_colour{0.88, 0.88, 0.88};
constexpr double tick_length = 0.35, label_distance = 0.6, title_space = 1.5;  // of the font size

// Only every n-th number along x is written, so that they do not run into each other.
std::size_t label_stride(const Axes& axes) {
  const Ticks& ticks = axes.x.ticks;
  std::vector<double> half;
  for (const std::string& label : ticks.labels)
    half.push_back(0.5 * text_extent(label, axes.font_size).width);
  std::size_t stride = 1;
  for (std::size_t i = 0; i + stride < half.size();) {
    const double distance = axes.place(ticks.values[i + stride], axes.y.low).x -
                            axes.place(ticks.values[i], axes.y.low).x;
    if (distance < half[i] + half[i + stride] + 0.4 * axes.font_size) {
      ++stride;
      i = 0;
    } else {
      i += stride;
    }
  }
  return stride;
}

}  // namespace

double Axis::share(double value) const {
  if (!logarithmic) return (value - low) / (high - low);
  return std::log(value / low) / std::log(high / low);
}

Axis Axis::linear(double low, double high, double length, double spacing) {
  const int count = std::clamp(static_cast<int>(length / spacing), 1, 12);
  return {low, high, false, nice_ticks(low, high, count), {}};
}

Axis Axis::decades(double low, double high) {
  return {low, high, true, decade_ticks(low, high), {}};
}

void Axes::draw_grid(Canvas& canvas) const {
  for (const double value : x.ticks.values)
    canvas.line({place(value, y.low), place(value, y.high)}, 1, grid_colour);
  for (const double value : y.ticks.values)
    canvas.line({place(x.low, value), place(x.high, value)}, 1, grid_colour);
}

void Axes::draw(Canvas& canvas) const {
  canvas.line({{frame.left, frame.top},
               {frame.right(), frame.top},
               {frame.right(), frame.bottom()},
               {frame.left, frame.bottom()},
               {frame.left, frame.top}},
              1, frame_colour);
  const double tick = tick_length * font_size, label = label_distance * font_size;
  const std::size_t stride = label_stride(*this);
  for (std::size_t i = 0; i < x.ticks.values.size(); ++i) {
    const PixelPosition at = place(x.ticks.values[i], y.low);
    canvas.line({at, {at.x, at.y + tick}}, 1, frame_colour);
    if (i % stride == 0)
      canvas.text(x.ticks.labels[i], {at.x, at.y + label},
                  {.size = font_size, .horizontal = Align::centre, .vertical = Align::after});
  }
  for (std::size_t i = 0; i < y.ticks.values.size(); ++i) {
    const PixelPosition at = place(x.low, y.ticks.values[i]);
    canvas.line({at, {at.x - tick, at.y}}, 1, frame_colour);
    canvas.text(y.ticks.labels[i], {at.x - label, at.y},
                {.size = font_size, .horizontal = Align::before});
  }
  canvas.text(x.title,
              {frame.left + 0.5 * frame.width, frame.bottom() + bottom_margin(x, font_size)},
              {.size = font_size, .horizontal = Align::centre, .vertical = Align::before});
  canvas.text(
      y.title, {frame.left - left_margin(y, font_size), frame.top + 0.5 * frame.height},
      {.size = font_size, .horizontal = Align::centre, .vertical = Align::after, .upwards = true});
}

double left_margin(const Axis& y, double font_size) {
  double width = 0;
  for (const std::string& label : y.ticks.labels)
    width = std::max<double>(width, text_extent(label, font_size).width);
  return width + (label_distance + (y.title.empty() ? 0 : title_space)) * font_size;
}

double bottom_margin(const Axis& x, double font_size) {
  return (label_distance + 1.2 + (x.title.empty() ? 0 : title_space)) * font_size;
}

}  // namespace rfm
