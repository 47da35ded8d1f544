#pragma once

#include <array>
#include <cstdint>

#include "quadrature/surface.hpp"
#include "quadrature/truth_table.hpp"

namespace rfm {

/// Signs of the surfaces of an active set: bit i is set where surface i is ≥ 0 (sign(0) = +).
using SurfaceSigns = std::uint32_t;

/// The surfaces that may matter in a box: first the variables of the truth table that decides what
/// is inside, then interfaces, on which the table does not depend but which split the rules.
struct ActiveSet {
  static constexpr int capacity = 16;
  /// The number of a surface that is no piece of the boundary (the side of a cell).
  static constexpr int no_piece = -1;

  int count = 0;
  TruthTable table{true};
  std::array<const Surface*, capacity> surfaces{};
  /// Number of the primitive or interface.
  std::array<int, capacity> numbers{};

  int region_count() const { return table.variable_count(); }
  bool is_interface(int surface) const { return surface >= region_count(); }
  bool inside(SurfaceSigns signs) const {
    return table.value(signs & ((1u << region_count()) - 1));
  }
  void add(const Surface& surface, int number) {
    surfaces[count] = &surface;
    numbers[count++] = number;
  }
  /// Removes a surface whose sign is known.
  void fix(int surface, bool positive);
};

inline void ActiveSet::fix(int surface, bool positive) {
  if (!is_interface(surface)) table.fix(surface, positive);
  for (int i = surface; i + 1 < count; ++i) {
    surfaces[i] = surfaces[i + 1];
    numbers[i] = numbers[i + 1];
  }
  --count;
}

}  // namespace rfm
