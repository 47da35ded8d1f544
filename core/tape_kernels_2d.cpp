#include "core/tape_kernels.hpp"

namespace rfm {

template <>
Kernel find_kernel_in<2>(Operation operation, int order) {
  switch (order) {
    case 0:
      return Kernels<2, 0>::find(operation);
    case 1:
      return Kernels<2, 1>::find(operation);
    case 2:
      return Kernels<2, 2>::find(operation);
    case 3:
      return Kernels<2, 3>::find(operation);
    case 4:
      return Kernels<2, 4>::find(operation);
    default:
      return nullptr;
  }
}

}  // namespace rfm
