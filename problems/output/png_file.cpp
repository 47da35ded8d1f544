#include <png.h>

#include "core/error.hpp"
#include "problems/output/image.hpp"

namespace rfm {

void write_png(const Image& image, const std::string& path) {
  png_image file{};
  file.version = PNG_IMAGE_VERSION;
  file.width = static_cast<png_uint_32>(image.width());
  file.height = static_cast<png_uint_32>(image.height());
  file.format = PNG_FORMAT_RGB;
  constexpr int as_they_are = 0, rows_without_gaps = 0;
  if (!png_image_write_to_file(&file, path.c_str(), as_they_are, image.bytes().data(),
                               rows_without_gaps, nullptr))
    throw ComputationError("cannot write " + path + " (" + file.message + ")");
}

}  // namespace rfm
