#include "problems/output/colour_bar.hpp"

#include <algorithm>
#include <cmath>

#include "problems/output/ticks.hpp"

namespace rfm {
namespace {

constexpr int fewest_ticks = 2, most_ticks = 10;

Ticks bar_ticks(const ColourScale& scale, double height, double font_size) {
  const int count =
      std::clamp(static_cast<int>(height / (3.5 * font_size)), fewest_ticks, most_ticks);
  return nice_ticks(scale.low(), scale.high(), count);
}

double tick_length(double font_size) { return 0.35 * font_size; }

}  // namespace

void draw_colour_bar(Canvas& canvas, const PixelRectangle& bar, const ColourScale& scale,
                     const ColourBarStyle& style) {
  const auto height_of = [&](double value) {
    return bar.bottom() - bar.height * (value - scale.low()) / (scale.high() - scale.low());
  };
  const int top = static_cast<int>(std::floor(bar.top)),
            bottom = static_cast<int>(std::ceil(bar.bottom()));
  for (int row = top; row < bottom; ++row) {
    const double share = (bar.bottom() - row - 0.5) / bar.height;
    canvas.fill({{bar.left, std::max<double>(row, bar.top)},
                 {bar.right(), std::max<double>(row, bar.top)},
                 {bar.right(), std::min<double>(row + 1, bar.bottom())},
                 {bar.left, std::min<double>(row + 1, bar.bottom())}},
                scale(scale.low() + share * (scale.high() - scale.low())));
  }
  for (const double level : style.levels)
    if (level > scale.low() && level < scale.high())
      canvas.line({{bar.left, height_of(level)}, {bar.right(), height_of(level)}}, 1, black, 0.6);
  canvas.line({{bar.left, bar.top},
               {bar.right(), bar.top},
               {bar.right(), bar.bottom()},
               {bar.left, bar.bottom()},
               {bar.left, bar.top}},
              1, black);
  const Ticks ticks = bar_ticks(scale, bar.height, style.font_size);
  const double length = tick_length(style.font_size);
  for (std::size_t i = 0; i < ticks.values.size(); ++i) {
    const double y = height_of(ticks.values[i]);
    canvas.line({{bar.right(), y}, {bar.right() + length, y}}, 1, black);
    canvas.text(ticks.labels[i], {bar.right() + 1.7 * length, y}, {.size = style.font_size});
  }
  // A title longer than bar and numbers ends at the side of the picture.
  const double title_width = text_extent(style.title, style.font_size).width;
  const double left = std::min(bar.left, canvas.width() - 0.5 * style.font_size - title_width);
  canvas.text(style.title, {left, bar.top - 0.6 * style.font_size},
              {.size = style.font_size, .vertical = Align::before});
}

double colour_bar_label_width(const ColourScale& scale, double font_size) {
  std::string longest;
  for (int count = fewest_ticks; count <= most_ticks; ++count)
    for (const std::string& label : nice_ticks(scale.low(), scale.high(), count).labels)
      if (label.size() > longest.size()) longest = label;
  // Labels of as many characters differ by little.
  return text_extent(longest, font_size).width + 2.2 * tick_length(font_size);
}

}  // namespace rfm
