#include "core/tape_kernels.hpp"

namespace rfm {

template Kernel find_compiled_kernel<3, 0, 0>(Operation);
template Kernel find_compiled_kernel<3, 0, 1>(Operation);
template Kernel find_compiled_kernel<3, 0, 2>(Operation);
template Kernel find_compiled_kernel<3, 0, 3>(Operation);
template Kernel find_compiled_kernel<3, 1, 0>(Operation);
template Kernel find_compiled_kernel<3, 1, 1>(Operation);
template Kernel find_compiled_kernel<3, 1, 2>(Operation);
template Kernel find_compiled_kernel<3, 1, 3>(Operation);

}  // namespace rfm
