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

/// aᵉ, e known up to `lost`, beside a factor known up to `relative`: both are made up for in
/// bounds, |a^δ − 1| ≤ 2 |δ log a| as long as that is small; of plain numbers the first is, by the
/// factor a^δ ≈ 1 + δ log a.
template <class T>
T power_known_to(const T& a, double exponent, double lost, double) {
  using rfm::power, std::log;
  const T known = power(a, exponent);
  if (lost == 0) return known;
  return known + select(less(T(0.0), a), T(known * (T(lost) * T(log(a)))), T(0.0));
}
inline Interval power_known_to(const Interval& a, double exponent, double lost, double relative) {
  const double error = error_of_power(a, relative, lost);
  return power(a, exponent) * Interval(1 - error, 1 + error);
}

/// aᵉ⁻ᵏ for a ≥ 0 as it stands in the k-th derivative of aᵉ, beside a coefficient that has at most
/// 3k roundings; e − k itself is rounded.
template <class T>
T lowered_power(const T& a, double exponent, int k) {
  const double lowered = exponent - k, back = lowered - exponent;
  const double lost = (exponent - (lowered - back)) + (-k - back);
  return power_known_to(a, lowered, lost, k * 0x1p-51);
}

/// aᵉ for a ≥ 0; at a = 0, if e > 0, the singular coefficients are 0.
template <class T, int N, int K>
Jet<T, N, K> real_power(const Jet<T, N, K>& a, double exponent) {
  using rfm::power;
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

/// aᵇ for a > 0: exp(b log a), for plain numbers as a^β exp((b − β) log a) with the value β of b.
/// The derivatives of the first factor by a follow from each other without cancelling.
template <class T, int N, int K>
Jet<T, N, K> regular_power(const Jet<T, N, K>& a, const Jet<T, N, K>& b) {
  const Jet<T, N, K> logarithm = log(a);
  if constexpr (std::is_floating_point_v<T> || std::is_same_v<T, Batch>) {
    using std::exp;
    const T exponent = b.c[0];
    TaylorSeries<T, K> taylor;
    taylor[0] = exp(T(exponent * logarithm.c[0]));
    for (int k = 1; k <= a.order(); ++k)
      taylor[k] = taylor[k - 1] * ((exponent - T(k - 1.0)) / (T(double(k)) * a.c[0]));
    Jet<T, N, K> change = b;
    change.c[0] = T(0.0);
    Jet<T, N, K> result = compose(a, taylor) * rfm::exp(change * logarithm);
    result.c[0] = taylor[0];
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
