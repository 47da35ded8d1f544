#pragma once

#include <vector>

namespace rfm {

/// Values of what fields may depend on beside the coordinates.
struct FieldArguments {
  double time = 0;
  std::vector<double> parameters{};
};

}  // namespace rfm
