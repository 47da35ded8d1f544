#include "core/tape_kernels.hpp"

namespace rfm {

template Kernel find_compiled_kernel<1, 2, 0>(Operation);
template Kernel find_compiled_kernel<1, 2, 1>(Operation);
template Kernel find_compiled_kernel<1, 2, 2>(Operation);
template Kernel find_compiled_kernel<1, 2, 3>(Operation);

}  // namespace rfm
