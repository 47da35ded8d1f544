#pragma once

#include <array>

namespace rfm {

/// A triangle by the numbers of its vertices, and what it belongs to.
struct Facet {
  std::array<int, 3> vertices{};
  int primitive = 0;
};

}  // namespace rfm
