#pragma once

#include <cmath>

#include "core/jet_scaling.hpp"

namespace rfm {

// Functions of jets that choose between branches by the values of their arguments. At the place
// where branches meet the derivatives are those of the branch that is taken.

// What depends on a comparison with NaN is NaN itself: a point outside the domain of a function
// must not pass for the other side of a condition.

template <class T, int N, int K>
Jet<T, N, K> nan_where_nan(Jet<T, N, K> f, const Jet<T, N, K>& argument) {
  for (T& coefficient : f.c) coefficient = nan_where_nan(coefficient, argument.c[0]);
  return f;
}

template <class T, int N, int K>
Jet<T, N, K> floor(const Jet<T, N, K>& a) {
  using std::floor;  // + 0: never −0, so that it is one number over [0, 1), −0 included
  return nan_where_nan(Jet<T, N, K>::constant(floor(a.c[0]) + T(0.0)), a);
}

/// 1 where the mask holds, else 0.
template <class T, int N, int K>
Jet<T, N, K> indicator(const auto& mask, const Jet<T, N, K>& argument) {
  return nan_where_nan(Jet<T, N, K>::constant(select(mask, T(1.0), T(0.0))), argument);
}

template <class T, int N, int K>
Jet<T, N, K> step(const Jet<T, N, K>& a) {
  return indicator(less_equal(T(0.0), a.c[0]), a);
}

template <class T, int N, int K>
Jet<T, N, K> less_than(const Jet<T, N, K>& a, const Jet<T, N, K>& b) {
  return nan_where_nan(indicator(less(a.c[0], b.c[0]), a), b);
}

template <class T, int N, int K>
Jet<T, N, K> at_most(const Jet<T, N, K>& a, const Jet<T, N, K>& b) {
  return nan_where_nan(indicator(less_equal(a.c[0], b.c[0]), a), b);
}

template <class T, int N, int K>
Jet<T, N, K> equals(const Jet<T, N, K>& a, const Jet<T, N, K>& b) {
  return nan_where_nan(indicator(equal(a.c[0], b.c[0]), a), b);
}

template <class T, int N, int K>
Jet<T, N, K> choose(const Jet<T, N, K>& condition, const Jet<T, N, K>& yes,
                    const Jet<T, N, K>& no) {
  return nan_where_nan(select(equal(condition.c[0], T(0.0)), no, yes), condition);
}

template <class T, int N, int K>
Jet<T, N, K> sign(const Jet<T, N, K>& a) {
  const T negative_or_zero = select(less(a.c[0], T(0.0)), T(-1.0), T(0.0));
  return nan_where_nan(
      Jet<T, N, K>::constant(select(less(T(0.0), a.c[0]), T(1.0), negative_or_zero)), a);
}

template <class T, int N, int K>
Jet<T, N, K> abs(const Jet<T, N, K>& a) {
  Jet<T, N, K> result = select(less(a.c[0], T(0.0)), -a, a);
  if constexpr (is_plain<T>) result.c[0] = result.c[0] + T(0.0);  // |−0| is 0
  return result;
}

template <class T, int N, int K>
Jet<T, N, K> min(const Jet<T, N, K>& a, const Jet<T, N, K>& b) {
  return select(less_or_nan(b.c[0], a.c[0]), b, a);
}

template <class T, int N, int K>
Jet<T, N, K> max(const Jet<T, N, K>& a, const Jet<T, N, K>& b) {
  return select(greater_or_nan(b.c[0], a.c[0]), b, a);
}

/// a − b ⌊a / b⌋.
template <class T, int N, int K>
Jet<T, N, K> mod(const Jet<T, N, K>& a, const Jet<T, N, K>& b) {
  if constexpr (requires { floored_remainder(a.c[0], b.c[0]); }) {
    // Next to multiples of b the quotient may round to the wrong whole number.
    using std::floor;
    const T rest = floored_remainder(a.c[0], b.c[0]), multiple = a.c[0] - rest;
    const T quotient = floor(multiple / b.c[0] + T(0.5));
    Jet<T, N, K> result = a - scaled(quotient, b);
    if (any(is_infinite(quotient))) [[unlikely]]
      result = select(is_infinite(quotient), a - scaled(multiple, in_units_of(b.c[0], b)), result);
    result.c[0] = rest;
    return result;
  } else {
    return a - b * floor(a / b);
  }
}

}  // namespace rfm
