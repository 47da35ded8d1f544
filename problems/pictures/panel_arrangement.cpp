#include "problems/pictures/panel_arrangement.hpp"

#include <cmath>

namespace rfm {
namespace {

// Between views, as a part of their width; the line above a view, in heights of its font.
constexpr double gap = 0.04, line = 1.8;
// The same as a part of the width of a view, about.
constexpr double line_share = 0.06;

}  // namespace

PanelArrangement PanelArrangement::of(const ViewWindow& window, int count) {
  const double aspect = window.height() / window.width();
  constexpr double flat = 0.5;
  PanelArrangement arrangement;
  (aspect < flat ? arrangement.rows : arrangement.columns) = count;
  arrangement.aspect = arrangement.rows * (aspect + line_share) /
                       (arrangement.columns + gap * (arrangement.columns - 1));
  return arrangement;
}

PixelRectangle PanelArrangement::place(int number, const PixelRectangle& whole,
                                       double font_size) const {
  const double width = whole.width / (columns + gap * (columns - 1)), height = whole.height / rows;
  const double above = std::floor(line * font_size);
  return {std::round(whole.left + number % columns * (1 + gap) * width),
          std::round(whole.top + number / columns * height + above), std::floor(width),
          std::floor(height - above)};
}

}  // namespace rfm
