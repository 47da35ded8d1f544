#pragma once

#include <initializer_list>
#include <string>

#include "problems/output/coverage.hpp"
#include "problems/output/image.hpp"

namespace rfm {

/// Where a text stands relative to the place it is given.
enum class Align { before, centre, after };

struct TextStyle {
  double size = 16;  ///< height of the font in pixels
  Colour colour = black;
  /// `after`: the text begins at the place; `before`: it ends there.
  Align horizontal = Align::after;
  /// `after`: below the place; `before`: above it; `centre`: digits and capitals are centred.
  Align vertical = Align::centre;
  bool upwards = false;  ///< turned by 90°, reading upwards
  double halo = 0;       ///< width of a rim of `halo_colour` that keeps text readable on colours
  Colour halo_colour = white;
};

/// Anti-aliased drawing on an image: filled polygons, lines, arrows and text. Whatever lies beyond
/// the image is cut off.
///
///     Canvas canvas(800, 600);
///     canvas.line({{10, 10}, {300, 200}}, 2, black);
///     canvas.text("u = 1", {305, 200}, {.size = 18});
///     write_png(canvas.image(), "picture.png");
class Canvas {
 public:
  Canvas(int width, int height, const Colour& background = white)
      : image_(width, height, background) {}

  int width() const { return image_.width(); }
  int height() const { return image_.height(); }
  Image& image() { return image_; }
  const Image& image() const { return image_; }

  void fill(std::span<const PixelPosition> corners, const Colour& colour, double opacity = 1);
  void fill(std::initializer_list<PixelPosition> corners, const Colour& colour,
            double opacity = 1) {
    fill(std::span(corners.begin(), corners.size()), colour, opacity);
  }
  void line(std::span<const PixelPosition> points, double line_width, const Colour& colour,
            double opacity = 1);
  void line(std::initializer_list<PixelPosition> points, double line_width, const Colour& colour,
            double opacity = 1) {
    line(std::span(points.begin(), points.size()), line_width, colour, opacity);
  }
  /// A line with a filled head, its tip at `to`; the head is 4 line widths long, at most half of
  /// the arrow.
  void arrow(const PixelPosition& from, const PixelPosition& to, double line_width,
             const Colour& colour);
  void text(const std::string& text, const PixelPosition& place, const TextStyle& style = {});

 private:
  void paint(const Coverage& coverage, const Colour& colour, double opacity, int dx = 0,
             int dy = 0);
  Image image_;
};

/// Width and height of a text in pixels.
struct TextExtent {
  int width = 0, height = 0;
};
TextExtent text_extent(const std::string& text, double size);

/// The text shortened with an ellipsis to at most `width` pixels.
std::string fitted(const std::string& text, double size, double width);

}  // namespace rfm
