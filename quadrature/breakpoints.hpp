#pragma once

#include <array>
#include <vector>

namespace rfm {

/// Coordinates, per axis, where integrands are not smooth: rules are split there.
using Breakpoints = std::array<std::vector<double>, 3>;

}  // namespace rfm
