#pragma once

#include <string>

#include "problems/output/coverage.hpp"

namespace rfm {

/// A line of text as coverage of pixels, with its upper left corner at (0, 0): `ascent` pixels
/// stand above the baseline, whatever the letters, so that texts of one size line up.
struct TextImage {
  Coverage coverage;
  int ascent = 0;
};

/// Draws a text in DejaVu Sans. `text` is UTF-8; bytes that are not are left out, line breaks
/// become blanks, characters that the font lacks boxes. `size` is the height of the font in pixels.
/// Not for several threads at a time.
TextImage render_text(const std::string& text, double size);

/// Turned by 90°, so that it reads upwards.
Coverage turned_upwards(const Coverage& coverage);

}  // namespace rfm
