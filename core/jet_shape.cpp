#include "core/jet_shape.hpp"

#include <atomic>
#include <memory>
#include <mutex>
#include <string>

#include "core/error.hpp"

namespace rfm {
namespace {

// Calls `visit` with every multi-index of degree ≤ `order`, in any order.
template <class Visit>
void for_each_exponent(int variables, int order, const Visit& visit) {
  MultiIndex index{};
  const auto choose = [&](const auto& self, int axis, int left) -> void {
    if (axis == variables) return visit(index);
    for (int power = 0; power <= left; ++power) {
      index[axis] = static_cast<std::uint8_t>(power);
      self(self, axis + 1, left - power);
    }
    index[axis] = 0;
  };
  choose(choose, 0, order);
}

}  // namespace

JetShape::JetShape(int variables, int order) : variables_(variables), order_(order) {
  for (int degree = 0; degree <= order; ++degree) sizes_.push_back(jet_size(variables, degree));
  exponents_.resize(sizes_.back());
  for_each_exponent(variables, order, [&](const MultiIndex& index) {
    exponents_[jet_index(variables, index)] = index;
  });
  for (int axis = 0; axis < variables; ++axis)
    for (const MultiIndex& index : exponents_)
      raised_[axis].push_back(
          static_cast<std::uint16_t>(jet_index(variables, index + unit_index(axis))));
  terms_.reserve(jet_size(2 * variables, order));
  for (int result = 0; result < size(); ++result) {
    first_term_.push_back(static_cast<std::uint32_t>(terms_.size()));
    for (int left = 0; left <= result; ++left)
      if (divides(exponents_[left], exponents_[result]))
        terms_.push_back({static_cast<std::uint16_t>(left),
                          static_cast<std::uint16_t>(
                              jet_index(variables, exponents_[result] - exponents_[left]))});
  }
  first_term_.push_back(static_cast<std::uint32_t>(terms_.size()));
}

const JetShape& JetShape::get(int variables, int order) {
  if (variables < 1 || variables > maximum_variables || order < 0 || order > maximum_order)
    throw InvalidArgument("jets have 1 to " + std::to_string(maximum_variables) +
                          " variables and orders 0 to " + std::to_string(maximum_order) + ", not " +
                          std::to_string(variables) + " variables and order " +
                          std::to_string(order));
  static std::atomic<const JetShape*> known[maximum_variables][maximum_order + 1];
  static std::mutex making;
  static std::vector<std::unique_ptr<const JetShape>> owners;
  std::atomic<const JetShape*>& place = known[variables - 1][order];
  if (const JetShape* shape = place.load(std::memory_order_acquire)) return *shape;
  const std::lock_guard lock(making);
  if (!place.load(std::memory_order_relaxed)) {
    owners.emplace_back(new JetShape(variables, order));
    place.store(owners.back().get(), std::memory_order_release);
  }
  return *place.load(std::memory_order_relaxed);
}

}  // namespace rfm
