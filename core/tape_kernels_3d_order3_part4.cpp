#include "core/tape_kernels.hpp"

namespace rfm {

template Kernel find_compiled_kernel<3, 3, 3>(Operation);

}  // namespace rfm
