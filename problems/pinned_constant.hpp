#pragma once

#include <optional>

#include "solvers/linear_system.hpp"

namespace rfm {

/// Takes its best supported unknown out of a system whose kernel are the constants, and sets it to
/// zero: the level that the equations leave free. It is one of the first `count`, if not all of
/// them take part in a constant. For kernels of other functions: solvers/kernel.hpp.
void pin_one(LinearSystem& system, std::optional<Eigen::Index> count = {});

}  // namespace rfm
