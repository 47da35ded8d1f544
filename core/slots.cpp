#include "core/slots.hpp"

#include <algorithm>

#include "core/error.hpp"
#include "core/field_node.hpp"
#include "core/graph_derivative.hpp"

namespace rfm {
namespace {

std::vector<GraphDerivative> derivatives_along(const std::vector<Field>& slots) {
  std::vector<GraphDerivative> along;
  for (const Field& slot : slots) {
    const auto is_it = [&](const Field& other) {
      return other.node().operation == slot.node().operation &&
             other.node().index == slot.node().index;
    };
    if (std::ranges::count_if(slots, is_it) > 1)
      throw InvalidArgument("slots are different coordinates");
    along.emplace_back(slot);
  }
  return along;
}

std::vector<SlotSlope> gradient_of(const Field& function, std::vector<GraphDerivative>& along) {
  std::vector<SlotSlope> gradient;
  for (int i = 0; i < static_cast<int>(along.size()); ++i) {
    Field slope = along[i].where_defined(function);
    if (!slope.is_constant(0)) gradient.push_back({i, std::move(slope)});
  }
  return gradient;
}

}  // namespace

std::vector<SlotSlope> slot_gradient(const Field& function, const std::vector<Field>& slots) {
  std::vector<GraphDerivative> along = derivatives_along(slots);
  return gradient_of(function, along);
}

SlotDerivatives slot_derivatives(const Field& function, const std::vector<Field>& slots) {
  std::vector<GraphDerivative> along = derivatives_along(slots);
  SlotDerivatives found{gradient_of(function, along), {}};
  for (const auto& [row, slope] : found.gradient)
    for (int column = row; column < static_cast<int>(along.size()); ++column) {
      Field value = along[column].where_defined(slope);
      if (!value.is_constant(0)) found.hessian.push_back({row, column, std::move(value)});
    }
  return found;
}

}  // namespace rfm
