#include "core/tape_kernels.hpp"

namespace rfm {

template Kernel find_compiled_kernel<1, 0, 0>(Operation);
template Kernel find_compiled_kernel<1, 0, 1>(Operation);
template Kernel find_compiled_kernel<1, 0, 2>(Operation);
template Kernel find_compiled_kernel<1, 0, 3>(Operation);
template Kernel find_compiled_kernel<1, 1, 0>(Operation);
template Kernel find_compiled_kernel<1, 1, 1>(Operation);
template Kernel find_compiled_kernel<1, 1, 2>(Operation);
template Kernel find_compiled_kernel<1, 1, 3>(Operation);

}  // namespace rfm
