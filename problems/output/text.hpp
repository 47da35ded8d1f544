#pragma once

#include <string>

#include "problems/output/coverage.hpp"

namespace rfm {

/// A line of text as coverage of pixels, with its upper left corner at (0, 0): `ascent` pixels
/// stand above the baseline, whatever the letters, so that texts of one size line up.
///
/// The font is DejaVu Sans where it is installed, which knows Greek and mathematical signs, else
/// the Arial-like one within VTK, for which such letters are spelled out (θ as theta, − as -).
struct TextImage {
  Coverage coverage;
  int ascent = 0;
};

/// `text` is UTF-8; bytes that are not are left out, line breaks become blanks. `size` is the
/// height of the font in pixels. Not for several threads at a time.
TextImage render_text(const std::string& text, double size);

/// Turned by 90°, so that it reads upwards.
Coverage turned_upwards(const Coverage& coverage);

}  // namespace rfm
