#include "problems/output/image.hpp"

#include <algorithm>

#include "core/error.hpp"

namespace rfm {
namespace {

std::uint8_t byte(double part) {
  return static_cast<std::uint8_t>(std::clamp(part, 0.0, 1.0) * 255 + 0.5);
}

}  // namespace

Image::Image(int width, int height, const Colour& colour) : width_(width), height_(height) {
  if (width < 1 || height < 1) throw InvalidArgument("an image needs at least one pixel");
  bytes_.resize(offset(0, height));
  for (std::size_t i = 0; i < bytes_.size(); i += 3) {
    bytes_[i] = byte(colour.red);
    bytes_[i + 1] = byte(colour.green);
    bytes_[i + 2] = byte(colour.blue);
  }
}

Colour Image::pixel(int x, int y) const {
  const std::uint8_t* bytes = &bytes_[offset(x, y)];
  return {bytes[0] / 255.0, bytes[1] / 255.0, bytes[2] / 255.0};
}

void Image::set_pixel(int x, int y, const Colour& colour) {
  std::uint8_t* bytes = &bytes_[offset(x, y)];
  bytes[0] = byte(colour.red);
  bytes[1] = byte(colour.green);
  bytes[2] = byte(colour.blue);
}

}  // namespace rfm
