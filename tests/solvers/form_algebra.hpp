#pragma once

#include <vector>

#include "core/field.hpp"

namespace rfm::test {

inline Field dot(const std::vector<Field>& a, const std::vector<Field>& b) {
  Field sum = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) sum = sum + a[i] * b[i];
  return sum;
}
inline Field squared_slope(const Field& f) { return dot(gradient(f, 2), gradient(f, 2)); }

}  // namespace rfm::test
