#include "problems/output/picture_layout.hpp"

#include <algorithm>
#include <cmath>

namespace rfm {
namespace {

double title_size(double font_size) { return 1.3 * font_size; }

}  // namespace

double label_size(int picture_width) { return std::clamp(picture_width / 60.0, 9.0, 48.0); }

PictureLayout picture_layout(const PictureRequest& request) {
  PictureLayout layout;
  layout.width = request.width;
  layout.font_size = label_size(request.width);
  const double font = layout.font_size, margin = font;
  const bool has_bar_title = request.scale && !request.bar.title.empty();
  const double top = margin + (request.title.empty() ? 0 : 1.9 * title_size(font)) +
                     (has_bar_title ? 1.4 * font : 0);
  const double left = margin + request.left_margin;
  const double bar_width = 1.3 * font, gap = 1.4 * font;
  double right_space = request.right_margin;
  if (request.scale) right_space = gap + bar_width + colour_bar_label_width(*request.scale, font);
  const double room = std::max(1.0, request.width - left - right_space - margin);
  const double tallest = 1.25 * request.width, flattest = 0.25 * request.width;
  const double shown_width = std::min(room, tallest / request.aspect);
  const double shown_height = shown_width * request.aspect;
  const double frame_height = std::max(shown_height, request.scale ? flattest : shown_height);
  layout.shown = {std::round(left + 0.5 * (room - shown_width)),
                  std::round(top + 0.5 * (frame_height - shown_height)),
                  std::max(1.0, std::round(shown_width)), std::max(1.0, std::round(shown_height))};
  if (request.scale)
    layout.bar = {std::round(left + 0.5 * (room + shown_width) + gap), std::round(top), bar_width,
                  std::round(frame_height)};
  layout.height = static_cast<int>(std::ceil(
      top + std::max(frame_height + request.bottom_margin, request.least_height) + margin));
  return layout;
}

void draw_frame(Canvas& canvas, const PictureLayout& layout, const PictureRequest& request) {
  const double size = title_size(layout.font_size), margin = layout.font_size;
  canvas.text(fitted(request.title, size, layout.width - 2 * margin), {margin, margin + 0.6 * size},
              {.size = size});
  if (request.scale) {
    ColourBarStyle style = request.bar;
    style.font_size = layout.font_size;
    style.title = fitted(style.title, style.font_size, 0.7 * layout.width);
    draw_colour_bar(canvas, layout.bar, *request.scale, style);
  }
}

}  // namespace rfm
