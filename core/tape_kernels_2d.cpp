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
    default:
      return find_high_kernel_in<2>(operation, order);
  }
}

}  // namespace rfm
