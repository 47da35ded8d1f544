#include "core/tape_kernels.hpp"

namespace rfm {

template <>
Kernel find_kernel_in<3>(Operation operation, int order) {
  switch (order) {
    case 0:
      return Kernels<3, 0>::find(operation);
    case 1:
      return Kernels<3, 1>::find(operation);
    case 2:
      return Kernels<3, 2>::find(operation);
    default:
      return find_high_kernel_in<3>(operation, order);
  }
}

}  // namespace rfm
