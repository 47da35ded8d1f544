#pragma once

#include <memory>

#include "core/error.hpp"
#include "core/field.hpp"

namespace rfm {

/// A coordinate beyond x, y, z and t, numbered from 4 on: products of regions and Minkowski sums
/// depend on more than one point. Its values are given as `PointBlock::further`; jets may be taken
/// in it (`Variables`), and `derivative_with_respect_to` differentiates along it.
inline Field further_coordinate(int number) {
  if (number < 4) throw InvalidArgument("further coordinates are numbered from 4");
  auto node = std::make_shared<Field::Node>();
  node->operation = Operation::coordinate;
  node->index = number;
  return Field(std::shared_ptr<const Field::Node>(std::move(node)));
}

}  // namespace rfm
