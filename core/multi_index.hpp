#pragma once

#include <array>
#include <cstdint>

namespace rfm {

/// Jets have up to this many variables,
constexpr int maximum_variables = 4;
/// and, with tables at run time, orders up to this: 8, and room for derivatives of derivatives.
constexpr int maximum_order = 16;
/// Stands for a number of variables or an order that is known at run time only.
constexpr int run_time = -1;

/// Orders of differentiation along each variable.
using MultiIndex = std::array<std::uint8_t, maximum_variables>;

constexpr int degree(const MultiIndex& index) { return index[0] + index[1] + index[2] + index[3]; }

/// The multi-index that is 1 at `axis` alone.
constexpr MultiIndex unit_index(int axis) {
  MultiIndex index{};
  index[axis] = 1;
  return index;
}

constexpr MultiIndex operator+(const MultiIndex& a, const MultiIndex& b) {
  MultiIndex sum{};
  for (int i = 0; i < maximum_variables; ++i) sum[i] = static_cast<std::uint8_t>(a[i] + b[i]);
  return sum;
}

/// Requires `divides(b, a)`.
constexpr MultiIndex operator-(const MultiIndex& a, const MultiIndex& b) {
  MultiIndex difference{};
  for (int i = 0; i < maximum_variables; ++i)
    difference[i] = static_cast<std::uint8_t>(a[i] - b[i]);
  return difference;
}

/// Whether the monomial x^a divides x^b: a ≤ b along every variable.
constexpr bool divides(const MultiIndex& a, const MultiIndex& b) {
  for (int i = 0; i < maximum_variables; ++i)
    if (a[i] > b[i]) return false;
  return true;
}

/// α! = α₁! α₂! …
constexpr double factorial(const MultiIndex& index) {
  double product = 1;
  for (int i = 0; i < maximum_variables; ++i)
    for (int k = 2; k <= index[i]; ++k) product *= k;
  return product;
}

/// Number of coefficients of a jet: the number of monomials of degree ≤ `order`.
constexpr int jet_size(int variables, int order) {
  int size = 1;
  for (int i = 1; i <= variables; ++i) size = size * (order + i) / i;
  return size;
}

/// Degree of the monomial at a place among the coefficients of a jet.
constexpr int jet_degree(int variables, int place) {
  int degree = 0;
  while (jet_size(variables, degree) <= place) ++degree;
  return degree;
}

/// Place of a multi-index among the coefficients of a jet: by degree, then x before y before z
/// (1; x, y; x², xy, y²; …). A jet of lower order is therefore a prefix of one of higher order.
constexpr int jet_index(int variables, const MultiIndex& index) {
  int place = 0, remaining = degree(index);
  for (int i = 0; i < variables; ++i) {
    // All monomials of smaller total degree in the variables from i on come before.
    place += remaining > 0 ? jet_size(variables - i, remaining - 1) : 0;
    remaining -= index[i];
  }
  return place;
}

}  // namespace rfm
