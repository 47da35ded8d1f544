#pragma once

#include <memory>
#include <vector>

#include "core/box.hpp"
#include "core/field.hpp"

namespace rfm {

/// Knows in which boxes a part of a boundary may end, and where: most functions that are zero at
/// some end of a part are zero elsewhere, too.
class EndLocator {
 public:
  virtual ~EndLocator() = default;
  /// Removes from `ends` (numbers of functions) those at whose zeros no part ends within the box.
  virtual void narrow(const Box& box, std::vector<int>& ends) const = 0;
};

/// Where parts of a boundary end: smooth functions, one of which is zero wherever one of the parts
/// ends.
struct PartEnds {
  std::vector<Field> functions;
  /// Of many functions, those that matter in a box; null: all do everywhere.
  std::shared_ptr<const EndLocator> locator = nullptr;
};

}  // namespace rfm
