#pragma once

#include <cmath>
#include <type_traits>

#include "core/jet_functions.hpp"

namespace rfm {

// Powers of jets: with whole exponents by multiplication, with other numbers, and with jets.

template <class T, int N, int K>
Jet<T, N, K> integer_power(const Jet<T, N, K>& a, int exponent) {
  if (exponent < 0) return integer_power(Jet<T, N, K>(1.0) / a, -exponent);
  if (exponent == 0) return Jet<T, N, K>(1.0);
  Jet<T, N, K> base = a;
  while (exponent % 2 == 0) base = square(base), exponent /= 2;
  Jet<T, N, K> result = base;
  for (exponent /= 2; exponent > 0; exponent /= 2) {
    base = square(base);
    if (exponent % 2 == 1) result = result * base;
  }
  return result;
}

/// aᵉ⁻ᵏ for a ≥ 0 as it stands in the bounds of the k-th derivative of aᵉ, beside a coefficient
/// that has at most 3k roundings; e − k itself is rounded.
template <class T>
T lowered_power(const T& a, double exponent, int k) {
  const double lowered = exponent - k, back = lowered - exponent;
  const double lost = (exponent - (lowered - back)) + (-k - back);
  return power_known_to(a, lowered, lost, k * 0x1p-51);
}
/// aᵉ for a range of a, with e known up to `lost`, beside a factor known up to `relative`.
inline Interval power_known_to(const Interval& a, double exponent, double lost, double relative) {
  const double error = error_of_power(a, relative, lost);
  return power(a, exponent) * Interval(1 - error, 1 + error);
}

/// aᵉ, of which the value is known, by the coefficients of the binomial series of (a/a₀)ᵉ.
template <class T, int N, int K>
Jet<T, N, K> relative_power(const Jet<T, N, K>& a, const T& exponent, const T& value) {
  TaylorSeries<T, K> taylor;
  taylor[0] = value;
  for (int k = 1; k <= a.order(); ++k)
    taylor[k] = taylor[k - 1] * ((exponent - T(k - 1.0)) * T(1.0 / k));
  return compose(in_units_of(select(equal(a.c[0], T(0.0)), T(1.0), a.c[0]), a), taylor);
}

/// The same for numbers where a₀ or its power are so large or small that coefficients of the series
/// overflow or underflow: by a multiple of a near 1 and a power of two.
template <class T, int N, int K>
[[gnu::noinline, gnu::cold]] Jet<T, N, K> extreme_power(const Jet<T, N, K>& a, double exponent,
                                                        const T& value) {
  using rfm::power;
  if (std::fabs(exponent) > 1000) return relative_power(a, T(exponent), value);
  const BinaryScale<T> scale = binary_scale(a, a);
  Jet<T, N, K> near = a;
  multiply_by_powers_of_two(near, T(-scale.size), scale.step);
  near = relative_power(near, T(exponent), T(power(near.c[0], T(exponent))));
  multiply_by_powers_of_two(near, T(whole_of_product(scale.size, exponent)), T(-scale.step));
  near = scaled(T(power(T(2.0), T(part_of_product(scale.size, exponent)))), near);
  near.c[0] = value;
  return near;
}

/// aᵉ for a ≥ 0; at a = 0, if e > 0, the singular coefficients are 0.
template <class T, int N, int K>
Jet<T, N, K> real_power(const Jet<T, N, K>& a, double exponent) {
  using rfm::power;
  if (a.order() == 0) return Jet<T, N, K>::constant(T(power(a.c[0], exponent)));
  if constexpr (is_plain<T>) {
    const bool is_whole = exponent == std::floor(exponent) && std::fabs(exponent) < 0x1p30;
    const T value = power(a.c[0], T(exponent));
    if (!is_whole && (any(has_no_reciprocal(a.c[0])) || any(has_no_reciprocal(value))))
      return extreme_power(a, exponent, value);
    if (!is_whole) return relative_power(a, T(exponent), value);
    Jet<T, N, K> result = integer_power(a, static_cast<int>(exponent));
    result.c[0] = value;
    return result;
  } else {
    TaylorSeries<T, K> taylor;
    taylor[0] = power(a.c[0], exponent);
    double binomial = 1;
    for (int k = 1; k <= a.order(); ++k) {
      binomial *= (exponent - (k - 1)) / k;
      if (binomial == 0) {
        taylor[k] = T(0.0);
        continue;
      }
      const T singular = T(binomial) * lowered_power(a.c[0], exponent, k);
      const bool regular = exponent >= k || exponent < 0;
      taylor[k] = regular ? singular : select(equal(a.c[0], T(0.0)), T(0.0), singular);
    }
    return compose(a, taylor);
  }
}

/// aᵇ for a > 0: exp(b log a), for plain numbers as a^β exp((b − β) log a) with the value β of b.
template <class T, int N, int K>
Jet<T, N, K> regular_power(const Jet<T, N, K>& a, const Jet<T, N, K>& b) {
  const Jet<T, N, K> logarithm = log(a);
  if constexpr (is_plain<T>) {
    using std::exp;
    const T exponent = b.c[0] * logarithm.c[0], value = exp(exponent);
    Jet<T, N, K> change = b;
    change.c[0] = T(0.0);
    change = change * logarithm;
    // Either factor takes half of a value that is nearly out of range.
    const T half = select(has_no_reciprocal(value), T(0.5) * exponent, T(0.0));
    change.c[0] = half;
    const T rest = select(has_no_reciprocal(value), T(exp(half)), value);
    Jet<T, N, K> result = relative_power(a, b.c[0], rest) * rfm::exp(change);
    result.c[0] = value;
    return result;
  } else {
    return exp(b * logarithm);
  }
}

/// aᵇ = exp(b log a). At a = 0 its limit, 0⁰ = 1, and the derivatives of aᵇ for the whole number b
/// there; singular ones, among them all by b, are 0. For b < 0 they do not exist, as the value.
template <class T, int N, int K>
Jet<T, N, K> general_power(const Jet<T, N, K>& a, const Jet<T, N, K>& b) {
  const Jet<T, N, K> regular = regular_power(a, b);
  TaylorSeries<T, K> at_zero;
  at_zero[0] = select(equal(b.c[0], T(0.0)), T(1.0), regular.c[0]);
  for (int k = 1; k <= a.order(); ++k)
    at_zero[k] = select(equal(b.c[0], T(double(k))), T(1.0), T(T(0.0) * at_zero[0]));
  return select(equal(a.c[0], T(0.0)), compose(a, at_zero), regular);
}

}  // namespace rfm
