#pragma once

#include <optional>

#include "problems/output/canvas.hpp"
#include "problems/output/colour_map.hpp"
#include "problems/output/pixel_window.hpp"

namespace rfm {

/// A field over a region of the plane, sampled at the centre of every pixel.
struct FieldPicture {
  PixelWindow window;
  RegionPixels region;
  /// The scalar that is shown; of a vector its length. NaN is drawn grey.
  std::vector<double> value;
  /// |∇value| times the side of a pixel; empty without contour lines.
  std::vector<double> slope;
  /// Parts of the region whose boundaries are shown as thin lines: materials.
  std::vector<RegionPixels> parts;
  /// Of a vector field: its first two components; empty of a scalar.
  std::vector<double> vector_x, vector_y;
};

/// The smallest and largest finite value at pixels whose centre is inside; nothing if there is
/// none.
std::optional<ValueRange> range_of(const FieldPicture& picture);

struct FieldStyle {
  ColourScale scale;
  /// Contour lines: levels `first_level` + i · `level_step`; no lines for a step of 0. A line
  /// passes where |value − level| / |∇value| is less than half its width; where lines are closer
  /// than four pixels they fade, and nothing is drawn where the field is level.
  double first_level = 0, level_step = 0;
  double line_width = 1.2;
  double boundary_width = 2;
  /// Distance of arrows in pixels.
  double arrow_spacing = 32;
};

/// Paints a field with its upper left corner at pixel (left, top) of the canvas: colours inside,
/// what is there before outside, contour lines, the boundary, arrows. Arrows are white on dark and
/// black on light colours; their lengths are in proportion, up to the longest, which are as long as
/// arrows are apart (one in twenty may be longer and is cut to this length). Arrows that would
/// reach out of the region are left out.
void paint_field(Canvas& canvas, int left, int top, const FieldPicture& picture,
                 const FieldStyle& style);

}  // namespace rfm
