#include "problems/output/text.hpp"

#include <ft2build.h>
#include FT_FREETYPE_H

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string_view>
#include <vector>

#include "core/error.hpp"
#include "problems/output/font.hpp"

namespace rfm {
namespace {

// The Unicode characters of UTF-8; bytes that are none are left out, control characters are blanks.
std::vector<char32_t> characters(std::string_view text) {
  std::vector<char32_t> result;
  while (!text.empty()) {
    const auto first = static_cast<unsigned char>(text[0]);
    const std::size_t length = first < 0x80 ? 1 : first < 0xE0 ? 2 : first < 0xF0 ? 3 : 4;
    const bool is_first = first < 0x80 || (first >= 0xC2 && first < 0xF5);
    char32_t character = length == 1 ? first : first & (0xFFu >> (length + 1));
    std::size_t used = 1;
    while (is_first && used < length && used < text.size() &&
           (static_cast<unsigned char>(text[used]) & 0xC0) == 0x80)
      character = character << 6 | (static_cast<unsigned char>(text[used++]) & 0x3Fu);
    const bool is_whole = is_first && used == length;
    if (is_whole) result.push_back(character < 0x20 || character == 0x7F ? U' ' : character);
    text.remove_prefix(is_whole ? length : 1);
  }
  return result;
}

class Font {
 public:
  Font() {
    const auto bytes = font_bytes();
    if (FT_Init_FreeType(&library_) != 0 ||
        FT_New_Memory_Face(library_, bytes.data(), static_cast<FT_Long>(bytes.size()), 0, &face_) !=
            0)
      throw ComputationError("cannot load the font of pictures");
  }
  ~Font() {
    FT_Done_Face(face_);
    FT_Done_FreeType(library_);
  }
  Font(const Font&) = delete;
  Font& operator=(const Font&) = delete;

  FT_Face at_size(double size) {
    constexpr FT_UInt points_are_pixels = 72;
    FT_Set_Char_Size(face_, 0, std::max(64L, std::lround(64 * size)), points_are_pixels,
                     points_are_pixels);
    return face_;
  }

 private:
  FT_Library library_ = nullptr;
  FT_Face face_ = nullptr;
};

// Adds the glyph that is loaded at pixel (left, top) of the coverage.
void add_bitmap(const FT_Bitmap& bitmap, int left, int top, Coverage& coverage) {
  for (int y = 0; y < static_cast<int>(bitmap.rows); ++y)
    for (int x = 0; x < static_cast<int>(bitmap.width); ++x) {
      const int column = left + x, row = top + y;
      if (column < 0 || row < 0 || column >= coverage.width || row >= coverage.height) continue;
      float& amount = coverage.amount[static_cast<std::size_t>(row) * coverage.width + column];
      amount = std::max(amount, bitmap.buffer[y * bitmap.pitch + x] / 255.0f);
    }
}

}  // namespace

TextImage render_text(const std::string& text, double size) {
  static Font font;
  TextImage result;
  const std::vector<char32_t> content = characters(text);
  if (std::ranges::all_of(content, [](char32_t c) { return c == U' '; })) return result;
  const FT_Face face = font.at_size(size);
  constexpr FT_Int32 mode = FT_LOAD_TARGET_LIGHT;
  const auto pixels = [](FT_Pos position) { return static_cast<int>((position + 32) >> 6); };
  FT_Pos length = 0;
  for (const char32_t character : content)
    if (FT_Load_Char(face, character, mode) == 0) length += face->glyph->advance.x;
  result.ascent = pixels(face->size->metrics.ascender);
  Coverage& coverage = result.coverage;
  coverage.width = pixels(length) + 1;
  coverage.height = result.ascent - pixels(face->size->metrics.descender);
  coverage.amount.assign(static_cast<std::size_t>(coverage.width) * coverage.height, 0.0f);
  FT_Pos pen = 0;
  for (const char32_t character : content) {
    if (FT_Load_Char(face, character, mode | FT_LOAD_RENDER) != 0) continue;
    const FT_GlyphSlot glyph = face->glyph;
    add_bitmap(glyph->bitmap, pixels(pen) + glyph->bitmap_left, result.ascent - glyph->bitmap_top,
               coverage);
    pen += glyph->advance.x;
  }
  return result;
}

Coverage turned_upwards(const Coverage& coverage) {
  Coverage turned{coverage.left, coverage.top, coverage.height, coverage.width, {}};
  turned.amount.resize(coverage.amount.size());
  for (int y = 0; y < coverage.height; ++y)
    for (int x = 0; x < coverage.width; ++x)
      turned.amount[static_cast<std::size_t>(coverage.width - 1 - x) * turned.width + y] =
          coverage.amount[static_cast<std::size_t>(y) * coverage.width + x];
  return turned;
}

}  // namespace rfm
