#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace rfm {

/// A colour in sRGB, each part from 0 to 1.
struct Colour {
  double red = 0, green = 0, blue = 0;
};

inline constexpr Colour black{0, 0, 0};
inline constexpr Colour white{1, 1, 1};

/// `amount` of `b` over 1 − `amount` of `a`, as painting programs mix (in sRGB).
inline Colour mixed(const Colour& a, const Colour& b, double amount) {
  return {a.red + amount * (b.red - a.red), a.green + amount * (b.green - a.green),
          a.blue + amount * (b.blue - a.blue)};
}

/// A rectangle of pixels, 8 bits per colour. Pixel (x, y) covers [x, x + 1] × [y, y + 1]; x runs to
/// the right and y *down* from the upper left corner.
class Image {
 public:
  /// All pixels in one colour. Throws `InvalidArgument` unless both sizes are positive.
  Image(int width, int height, const Colour& colour = white);

  int width() const { return width_; }
  int height() const { return height_; }
  bool contains(int x, int y) const { return x >= 0 && y >= 0 && x < width_ && y < height_; }
  Colour pixel(int x, int y) const;
  /// Parts outside [0, 1] are clamped.
  void set_pixel(int x, int y, const Colour& colour);
  /// Lays `amount` (0 to 1) of `colour` over the pixel.
  void blend(int x, int y, const Colour& colour, double amount) {
    if (amount > 0) set_pixel(x, y, mixed(pixel(x, y), colour, amount));
  }
  /// Red, green, blue of each pixel, row by row from the top.
  const std::vector<std::uint8_t>& bytes() const { return bytes_; }

 private:
  std::size_t offset(int x, int y) const {
    return 3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) +
                static_cast<std::size_t>(x));
  }
  int width_, height_;
  std::vector<std::uint8_t> bytes_;
};

/// Writes a PNG file. Throws `ComputationError` if it cannot be written.
void write_png(const Image& image, const std::string& path);

}  // namespace rfm
