#include "core/tape_kernels.hpp"

namespace rfm {

template <>
Kernel find_kernel_in<1>(Operation operation, int order) {
  switch (order) {
    case 0:
      return Kernels<1, 0>::find(operation);
    case 1:
      return Kernels<1, 1>::find(operation);
    case 2:
      return Kernels<1, 2>::find(operation);
    case 3:
      return Kernels<1, 3>::find(operation);
    default:
      return nullptr;
  }
}

}  // namespace rfm
