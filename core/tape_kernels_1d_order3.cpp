#include "core/tape_kernels.hpp"

namespace rfm {

template Kernel find_compiled_kernel<1, 3, 0>(Operation);
template Kernel find_compiled_kernel<1, 3, 1>(Operation);
template Kernel find_compiled_kernel<1, 3, 2>(Operation);
template Kernel find_compiled_kernel<1, 3, 3>(Operation);

}  // namespace rfm
