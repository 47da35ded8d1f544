#include "problems/output/canvas.hpp"

#include <algorithm>
#include <cmath>

#include "problems/output/text.hpp"

namespace rfm {
namespace {

double shift(Align align, double before, double centre, double after) {
  return align == Align::before ? before : align == Align::centre ? centre : after;
}

// The coverage of all pixels within `radius` of the letters.
Coverage widened(const Coverage& letters, double radius) {
  const int margin = static_cast<int>(std::ceil(radius));
  Coverage rim{letters.left - margin,
               letters.top - margin,
               letters.width + 2 * margin,
               letters.height + 2 * margin,
               {}};
  rim.amount.assign(static_cast<std::size_t>(rim.width) * rim.height, 0.0f);
  for (int dy = -margin; dy <= margin; ++dy)
    for (int dx = -margin; dx <= margin; ++dx) {
      const double within = std::clamp(radius + 0.5 - std::hypot(dx, dy), 0.0, 1.0);
      if (within == 0) continue;
      for (int y = 0; y < letters.height; ++y)
        for (int x = 0; x < letters.width; ++x) {
          float& kept =
              rim.amount[static_cast<std::size_t>(y + dy + margin) * rim.width + x + dx + margin];
          kept =
              std::max(kept, static_cast<float>(within) *
                                 letters.amount[static_cast<std::size_t>(y) * letters.width + x]);
        }
    }
  return rim;
}

}  // namespace

void Canvas::paint(const Coverage& coverage, const Colour& colour, double opacity, int dx, int dy) {
  for (int y = 0; y < coverage.height; ++y)
    for (int x = 0; x < coverage.width; ++x) {
      const int column = coverage.left + x + dx, row = coverage.top + y + dy;
      if (image_.contains(column, row))
        image_.blend(column, row, colour,
                     opacity * coverage.amount[static_cast<std::size_t>(y) * coverage.width + x]);
    }
}

void Canvas::fill(std::span<const PixelPosition> corners, const Colour& colour, double opacity) {
  paint(polygon_coverage(corners, width(), height()), colour, opacity);
}

void Canvas::line(std::span<const PixelPosition> points, double line_width, const Colour& colour,
                  double opacity) {
  paint(line_coverage(points, line_width, width(), height()), colour, opacity);
}

void Canvas::arrow(const PixelPosition& from, const PixelPosition& to, double line_width,
                   const Colour& colour) {
  const double dx = to.x - from.x, dy = to.y - from.y, length = std::hypot(dx, dy);
  if (!(length > 0)) return;
  const double ex = dx / length, ey = dy / length;
  const double head = std::min(4 * line_width, 0.5 * length), half = 0.4 * head;
  const PixelPosition neck{to.x - head * ex, to.y - head * ey};
  line({from, {neck.x + 0.5 * ex, neck.y + 0.5 * ey}}, line_width, colour);
  fill({to, {neck.x - half * ey, neck.y + half * ex}, {neck.x + half * ey, neck.y - half * ex}},
       colour);
}

void Canvas::text(const std::string& text, const PixelPosition& place, const TextStyle& style) {
  TextImage rendered = render_text(text, style.size);
  if (rendered.coverage.width == 0) return;
  // Digits and capitals of common fonts are about 0.73 of the font's size above the baseline.
  const double height = rendered.coverage.height, width = rendered.coverage.width;
  const double along = shift(style.horizontal, -width, -0.5 * width, 0);
  const double across = shift(style.vertical, -height, -(rendered.ascent - 0.365 * style.size), 0);
  int left, top;
  if (style.upwards) {
    left = static_cast<int>(std::lround(place.x + across));
    top = static_cast<int>(std::lround(place.y - along - width));
    rendered.coverage = turned_upwards(rendered.coverage);
  } else {
    left = static_cast<int>(std::lround(place.x + along));
    top = static_cast<int>(std::lround(place.y + across));
  }
  if (style.halo > 0)
    paint(widened(rendered.coverage, style.halo), style.halo_colour, 1, left, top);
  paint(rendered.coverage, style.colour, 1, left, top);
}

TextExtent text_extent(const std::string& text, double size) {
  const Coverage coverage = render_text(text, size).coverage;
  return {coverage.width, coverage.height};
}

std::string fitted(const std::string& text, double size, double width) {
  if (text_extent(text, size).width <= width) return text;
  // The longest beginning that fits, by bisection over whole UTF-8 characters.
  std::size_t fits = 0, too_long = text.size();
  while (too_long - fits > 1) {
    const std::size_t middle = (fits + too_long) / 2;
    (text_extent(text.substr(0, middle) + "…", size).width <= width ? fits : too_long) = middle;
  }
  while (fits > 0 && (static_cast<unsigned char>(text[fits]) & 0xC0) == 0x80) --fits;
  return text.substr(0, fits) + "…";
}

}  // namespace rfm
