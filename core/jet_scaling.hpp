#pragma once

#include <algorithm>
#include <cmath>

#include "core/jet.hpp"

namespace rfm {

// Jets of which values or increments are so far from 1 that powers of them overflow or underflow,
// although what is made of them does not. Not for bounds.

/// The coefficients of `a` but the value as multiples of `unit`; the value is of no use.
template <class T, int N, int K>
Jet<T, N, K> in_units_of(const T& unit, Jet<T, N, K> a) {
  if constexpr (is_plain<T>) {
    if (any(has_no_reciprocal(unit))) [[unlikely]] {
      for (T& coefficient : a.c) coefficient = coefficient / unit;
      return a;
    }
  }
  return scaled(T(T(1.0) / unit), a);
}

/// Powers of two that bring jets near 1 in size, a(h) = 2^size ã(h / 2^step): the value to between
/// 1 and 2, if it is no zero, and the largest of the other coefficients, too, up to their degree.
template <class T>
struct BinaryScale {
  T size = T(0.0), step = T(0.0);
};

template <class T, int N, int K>
[[gnu::noinline, gnu::cold]] BinaryScale<T> binary_scale(const Jet<T, N, K>& a,
                                                         const Jet<T, N, K>& b) {
  using std::floor, std::max, std::min;
  const T most = T(4096.0);
  const auto exponent = [&](int i) {
    return T(max(binary_exponent(coefficient(a, i)), binary_exponent(coefficient(b, i))));
  };
  BinaryScale<T> scale;
  scale.size = exponent(0);
  scale.size = select(less(scale.size, -most), T(0.0), scale.size);
  scale.step = most;
  const int size = max(a.c.size(), b.c.size());
  for (int i = 1; i < size; ++i)
    scale.step = min(scale.step, T(floor((scale.size - exponent(i)) / T(degree_at(a, b, i)))));
  return scale;
}

/// 2^{size + degree · step} times the coefficients.
template <class T, int N, int K>
[[gnu::noinline, gnu::cold]] void multiply_by_powers_of_two(Jet<T, N, K>& a, const T& size,
                                                            const T& step) {
  for (int i = 0; i < static_cast<int>(a.c.size()); ++i)
    a.c[i] = times_power_of_two(a.c[i], size + T(degree_at(a, a, i)) * step);
}

/// f(a, b) for a function of degree one, f(c a, c b) = c f(a, b), c > 0, to which arguments far
/// from 1 in size are brought by powers of two. `function(a, b, m)` gives besides a number m, of
/// which the value of f is its value + m S, S the argument nearer to zero, which may be too small
/// to be scaled.
template <class T, int N, int K>
Jet<T, N, K> of_degree_one(const Jet<T, N, K>& a, const Jet<T, N, K>& b, const auto& function) {
  using std::abs, std::max;
  const T larger = max(T(abs(a.c[0])), T(abs(b.c[0])));
  T of_smaller = T(0.0);
  Jet<T, N, K> result;
  if (any(is_far_from_one(larger))) [[unlikely]] {
    const BinaryScale<T> scale = binary_scale(a, b);
    Jet<T, N, K> x = a, y = b;
    multiply_by_powers_of_two(x, T(-scale.size), scale.step);
    multiply_by_powers_of_two(y, T(-scale.size), scale.step);
    result = function(x, y, of_smaller);
    multiply_by_powers_of_two(result, scale.size, T(-scale.step));
  } else {
    result = function(a, b, of_smaller);
  }
  const T smaller = select(farther_from_zero(a.c[0], b.c[0]), b.c[0], a.c[0]);
  result.c[0] = result.c[0] + of_smaller * smaller;
  return result;
}

}  // namespace rfm
