#include "core/tape_kernels.hpp"

namespace rfm {

template <>
Kernel find_high_kernel_in<2>(Operation operation, int order) {
  return order == 4 ? Kernels<2, 4>::find(operation) : nullptr;
}

}  // namespace rfm
