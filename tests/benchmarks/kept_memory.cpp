#include "core/freed_memory.hpp"

namespace {

// Before main, which is that of the library of benchmarks.
[[maybe_unused]] const bool is_kept = (rfm::keep_freed_memory(), true);

}  // namespace
