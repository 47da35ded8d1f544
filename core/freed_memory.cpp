#include "core/freed_memory.hpp"

#include <cstdlib>  // says whether the library is glibc

#ifdef __GLIBC__
#include <malloc.h>
#endif

namespace rfm {

void keep_freed_memory() {
#ifdef __GLIBC__
  // Arrays up to this size come from the heap, and the heap is not cut back before it has so much
  // to spare. Larger arrays are rare, and the system returns them zeroed without a copy.
  constexpr int largest = 1 << 30, block = 1 << 26;
  mallopt(M_MMAP_THRESHOLD, 32 << 20);  // the most that glibc allows
  mallopt(M_TRIM_THRESHOLD, largest);
  mallopt(M_TOP_PAD, block);
#endif
}

}  // namespace rfm
