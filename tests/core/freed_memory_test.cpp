#include "core/freed_memory.hpp"

#include <gtest/gtest.h>

#ifdef __GLIBC__
#include <malloc.h>

#include <vector>

namespace rfm {
namespace {

std::size_t free_bytes() { return mallinfo2().fordblks; }

// An array that nobody sees is not allocated by optimising compilers.
const char* volatile seen;

TEST(FreedMemory, IsKeptForTheNextArray) {
  keep_freed_memory();
  constexpr std::size_t size = 16 << 20;  // more than what malloc maps by itself
  {
    const std::vector<char> array(size);
    seen = array.data();
  }
  EXPECT_GE(free_bytes(), size);
  const std::size_t before = free_bytes();
  const std::vector<char> next(size);
  seen = next.data();
  EXPECT_LE(free_bytes(), before - size);
}

}  // namespace
}  // namespace rfm
#endif
