#pragma once

#include "solvers/linear_system.hpp"

namespace rfm {

/// Takes its best supported unknown out of a system whose kernel are the constants, and sets it to
/// zero: the level that the equations leave free. For kernels of other functions:
/// solvers/kernel.hpp.
void pin_one(LinearSystem& system);

}  // namespace rfm
