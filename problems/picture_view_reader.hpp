#pragma once

#include "problems/value_reader.hpp"

namespace rfm {

/// Reads how a picture looks at a body in space: `view` and `cut`. In other dimensions they are
/// mistakes.
void read_view(const DocumentNode& picture_node, const ValueReader& values, Picture& picture);

}  // namespace rfm
