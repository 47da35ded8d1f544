#include "core/tape_kernels.hpp"

namespace rfm {

template <>
Kernel find_high_kernel_in<3>(Operation operation, int order) {
  return order == 3 ? Kernels<3, 3>::find(operation) : nullptr;
}

}  // namespace rfm
