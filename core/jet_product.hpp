#pragma once

#include <array>
#include <cstdint>
#include <utility>

#include "core/multi_index.hpp"

namespace rfm {

/// Enumerates the multi-indices of degree ≤ `left` in the axes from `axis` on, into their places.
template <int N, std::size_t size>
constexpr void list_exponents(std::array<MultiIndex, size>& list, MultiIndex index, int axis,
                              int left) {
  if (axis == N) {
    list[jet_index(N, index)] = index;
    return;
  }
  for (int power = 0; power <= left; ++power) {
    index[axis] = static_cast<std::uint8_t>(power);
    list_exponents<N>(list, index, axis + 1, left - power);
  }
}

/// The multi-indices of a jet, in order.
template <int N, int K>
constexpr auto jet_exponents() {
  std::array<MultiIndex, jet_size(N, K)> list{};
  list_exponents<N>(list, MultiIndex{}, 0, K);
  return list;
}

/// Multi-indices of a jet in order, computed at compile time.
template <int N, int K>
struct JetTables {
  static constexpr auto exponents = jet_exponents<N, K>();
};

/// A term of the product of two jets: the coefficients that are multiplied.
struct JetProductTerm {
  std::uint16_t left, right;
};

/// The terms of which coefficient `result` of a product in N variables is the sum, by their left
/// factors: the first has right = `result`, the last left = `result`. They do not depend on the
/// order of the jets.
template <int N, int result>
constexpr auto jet_product_terms() {
  constexpr auto exponents = jet_exponents<N, jet_degree(N, result)>();
  constexpr MultiIndex total = exponents[result];
  constexpr int count = (total[0] + 1) * (total[1] + 1) * (total[2] + 1) * (total[3] + 1);
  std::array<JetProductTerm, count> terms{};
  int place = 0;
  for (int left = 0; left <= result; ++left)
    if (divides(exponents[left], total))
      terms[place++] = {static_cast<std::uint16_t>(left),
                        static_cast<std::uint16_t>(jet_index(N, total - exponents[left]))};
  return terms;
}

/// Coefficient `result` of the product of two jets; without its last term it is what the
/// coefficients of `a` before `result` contribute.
template <int N, int result, bool with_last, class T, std::size_t size>
T convolution(const std::array<T, size>& a, const std::array<T, size>& b) {
  static constexpr auto terms = jet_product_terms<N, result>();
  // A value is rounded before it is used further, alike in every evaluator.
  if constexpr (result == 0) return T(0.0) + a[0] * b[0];
  return [&]<std::size_t... i>(std::index_sequence<i...>) {
    T sum = a[0] * b[terms[0].right];
    ((sum = sum + a[terms[i + 1].left] * b[terms[i + 1].right]), ...);
    return sum;
  }
  (std::make_index_sequence<terms.size() - (with_last ? 1 : 2)>{});
}

}  // namespace rfm
