#include "problems/output/font.hpp"

// RFM_FONT_FILE is found when the build is configured.
asm(R"(
  .section .rodata
  .balign 16
rfm_font_begin:
  .incbin ")" RFM_FONT_FILE R"("
rfm_font_end:
  .previous
)");
extern "C" const unsigned char rfm_font_begin[], rfm_font_end[];

namespace rfm {

std::span<const unsigned char> font_bytes() { return {rfm_font_begin, rfm_font_end}; }

}  // namespace rfm
