#pragma once

#include <span>

namespace rfm {

/// The bytes of the font of pictures, DejaVu Sans, which knows Greek and mathematical signs. It is
/// part of the program: no file is looked for when a picture is drawn.
std::span<const unsigned char> font_bytes();

}  // namespace rfm
