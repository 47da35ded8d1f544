#pragma once

#include <cmath>
#include <numbers>

#include "core/jet.hpp"

namespace rfm {

// Elementary functions of jets but powers (core/jet_powers.hpp): each is composed with its argument
// by its own Taylor coefficients at the value there.

template <class T, int N, int K>
Jet<T, N, K> sqrt(const Jet<T, N, K>& a) {
  using std::sqrt;
  TaylorSeries<T, K> taylor;
  taylor[0] = sqrt(a.c[0]);
  if (a.order() > 0) {
    // From the root: next to zero the reciprocal of the argument overflows before the slope does.
    taylor[1] = select(equal(a.c[0], T(0.0)), T(0.0), T(0.5) / taylor[0]);
    const T inverse = reciprocal_or_zero(a.c[0]);
    for (int k = 2; k <= a.order(); ++k) taylor[k] = T((1.5 - k) / k) * taylor[k - 1] * inverse;
  }
  return compose(a, taylor);
}

template <class T, int N, int K>
Jet<T, N, K> cbrt(const Jet<T, N, K>& a) {
  using std::cbrt;
  TaylorSeries<T, K> taylor;
  taylor[0] = cbrt(a.c[0]);
  if (a.order() > 0) {
    taylor[1] = select(equal(a.c[0], T(0.0)), T(0.0), T(1.0) / (T(3.0) * square(taylor[0])));
    const T inverse = reciprocal_or_zero(a.c[0]);
    for (int k = 2; k <= a.order(); ++k)
      taylor[k] = T(4.0 - 3 * k) / T(3.0 * k) * taylor[k - 1] * inverse;
  }
  return compose(a, taylor);
}

template <class T, int N, int K>
Jet<T, N, K> exp(const Jet<T, N, K>& a) {
  using std::exp;
  TaylorSeries<T, K> taylor;
  taylor[0] = exp(a.c[0]);
  for (int k = 1; k <= a.order(); ++k) taylor[k] = taylor[k - 1] * T(1.0 / k);
  return compose(a, taylor);
}

template <class T, int N, int K>
Jet<T, N, K> log(const Jet<T, N, K>& a) {
  using std::log;
  TaylorSeries<T, K> taylor;
  taylor[0] = log(a.c[0]);
  if (a.order() > 0) {
    // Where the logarithm is not defined its derivatives are not either.
    const T inverse = nan_where_nan(T(T(1.0) / a.c[0]), taylor[0]);
    T power = inverse;
    for (int k = 1; k <= a.order(); ++k) {
      taylor[k] = T((k % 2 == 1 ? 1.0 : -1.0) / k) * power;
      power = power * inverse;
    }
  }
  return compose(a, taylor);
}

/// The Taylor coefficients of a function whose derivatives repeat as `first`, `second`, ± those.
template <class T, int K>
TaylorSeries<T, K> alternating_series(int order, const T& first, const T& second, double sign) {
  TaylorSeries<T, K> taylor;
  double factor = 1;
  for (int k = 0; k <= order; ++k) {
    if (k > 0) factor /= k;
    if (k > 1 && k % 2 == 0) factor *= sign;
    taylor[k] = T(factor) * (k % 2 == 0 ? first : second);
  }
  return taylor;
}

template <class T, int N, int K>
Jet<T, N, K> sin(const Jet<T, N, K>& a) {
  using std::cos, std::sin, rfm::cos, rfm::sin;
  if (a.order() == 0) return Jet<T, N, K>::constant(sin(a.c[0]));
  return compose(a, alternating_series<T, K>(a.order(), sin(a.c[0]), cos(a.c[0]), -1));
}

template <class T, int N, int K>
Jet<T, N, K> cos(const Jet<T, N, K>& a) {
  using std::cos, std::sin, rfm::cos, rfm::sin;
  if (a.order() == 0) return Jet<T, N, K>::constant(cos(a.c[0]));
  return compose(a, alternating_series<T, K>(a.order(), cos(a.c[0]), -sin(a.c[0]), -1));
}

template <class T, int N, int K>
Jet<T, N, K> sinh(const Jet<T, N, K>& a) {
  using std::cosh, std::sinh;
  if (a.order() == 0) return Jet<T, N, K>::constant(sinh(a.c[0]));
  return compose(a, alternating_series<T, K>(a.order(), sinh(a.c[0]), cosh(a.c[0]), 1));
}

template <class T, int N, int K>
Jet<T, N, K> cosh(const Jet<T, N, K>& a) {
  using std::cosh, std::sinh;
  if (a.order() == 0) return Jet<T, N, K>::constant(cosh(a.c[0]));
  return compose(a, alternating_series<T, K>(a.order(), cosh(a.c[0]), sinh(a.c[0]), 1));
}

/// Taylor coefficients of the solution of f′ = 1 + sign f², tan (+) and tanh (−), from value and
/// slope.
template <class T, int K>
TaylorSeries<T, K> riccati_series(int order, const T& value, const T& slope, double sign) {
  TaylorSeries<T, K> taylor;
  taylor[0] = value;
  if (order > 0) taylor[1] = slope;
  for (int k = 1; k < order; ++k) {
    T sum = T(0.0);
    for (int i = 0; i <= k; ++i) sum = sum + taylor[i] * taylor[k - i];
    taylor[k + 1] = T(sign / (k + 1)) * sum;
  }
  return taylor;
}

template <class T, int N, int K>
Jet<T, N, K> tan(const Jet<T, N, K>& a) {
  using std::tan;
  const T value = tan(a.c[0]);
  return compose(a, riccati_series<T, K>(a.order(), value, T(T(1.0) + square(value)), 1));
}

template <class T, int N, int K>
Jet<T, N, K> tanh(const Jet<T, N, K>& a) {
  using std::cosh, std::tanh;
  if (a.order() == 0) return Jet<T, N, K>::constant(tanh(a.c[0]));
  // 1 − tanh² would cancel.
  const T slope = square(T(T(1.0) / cosh(a.c[0])));
  return compose(a, riccati_series<T, K>(a.order(), T(tanh(a.c[0])), slope, -1));
}

/// The jet in one variable at the value of `a`, one order lower: derivatives of inverse functions
/// are built from it.
template <class T, int N, int K>
auto own_variable(const Jet<T, N, K>& a) {
  return Jet<T, 1, (K > 0 ? K - 1 : 0)>::variable(0, a.c[0]);
}

/// Taylor coefficients of a primitive of g = (1 ∓ x²)^{−1/2}, from its value, g(x) and i = ±1/(1 ∓
/// x²): (1 ∓ x²) g′ = ±x g, so that g_{k+1} = i ((2k + 1) x g_k + k g_{k−1}) / (k + 1).
template <class T, int K>
TaylorSeries<T, K> inverse_root_primitive(int order, const T& value, const T& slope, const T& x,
                                          const T& inverse) {
  TaylorSeries<T, K> taylor;
  taylor[0] = value;
  T before = T(0.0), last = slope;
  for (int k = 0; k < order; ++k) {
    taylor[k + 1] = last * T(1.0 / (k + 1));
    if (k + 1 == order) break;
    const T next = inverse * (T((2 * k + 1.0) / (k + 1)) * (x * last) + T(k / (k + 1.0)) * before);
    before = last;
    last = next;
  }
  return taylor;
}

template <class T, int N, int K>
Jet<T, N, K> asin(const Jet<T, N, K>& a) {
  using std::asin;
  if (a.order() == 0) return Jet<T, N, K>::constant(asin(a.c[0]));
  // (1 − a)(1 + a) does not cancel next to ±1, where the derivatives are 0 by convention.
  const T rest = (T(1.0) - a.c[0]) * (T(1.0) + a.c[0]);
  using std::sqrt;
  const T slope = select(equal(rest, T(0.0)), T(0.0), T(1.0) / T(sqrt(rest)));
  return compose(a, inverse_root_primitive<T, K>(a.order(), T(asin(a.c[0])), slope, a.c[0],
                                                 reciprocal_or_zero(rest)));
}

template <class T, int N, int K>
Jet<T, N, K> acos(const Jet<T, N, K>& a) {
  using std::acos;
  Jet<T, N, K> result = -asin(a);
  result.c[0] = acos(a.c[0]);
  return result;
}

template <class T, int N, int K>
Jet<T, N, K> atan(const Jet<T, N, K>& a) {
  using std::atan;
  if (a.order() == 0) return Jet<T, N, K>::constant(atan(a.c[0]));
  const auto x = own_variable(a);
  const decltype(x) one(1.0);
  return compose_primitive(a, T(atan(a.c[0])), one / (one + x * x));
}

template <class T, int N, int K>
Jet<T, N, K> asinh(const Jet<T, N, K>& a) {
  using std::asinh;
  if (a.order() == 0) return Jet<T, N, K>::constant(asinh(a.c[0]));
  const T slope = T(1.0) / length_with_one(a.c[0]);
  return compose(a, inverse_root_primitive<T, K>(a.order(), T(asinh(a.c[0])), slope, a.c[0],
                                                 T(T(-1.0) / (T(1.0) + square(a.c[0])))));
}

template <class T, int N, int K>
Jet<T, N, K> erf(const Jet<T, N, K>& a) {
  using std::erf;
  if (a.order() == 0) return Jet<T, N, K>::constant(erf(a.c[0]));
  // g = f′ has g′ = −2 x g.
  using std::exp;
  const T x = a.c[0];
  TaylorSeries<T, K> taylor;
  taylor[0] = erf(x);
  T before = T(0.0), last = T(2 * std::numbers::inv_sqrtpi) * T(exp(-square(x)));
  for (int k = 0; k < a.order(); ++k) {
    taylor[k + 1] = last * T(1.0 / (k + 1));
    const T next = T(-2.0 / (k + 1)) * (x * last + before);
    before = last;
    last = next;
  }
  return compose(a, taylor);
}

/// The angle of (x, y): all derivatives are those of atan(y/x) or of −atan(x/y), whichever quotient
/// is the smaller.
template <class T, int N, int K>
Jet<T, N, K> atan2(const Jet<T, N, K>& y, const Jet<T, N, K>& x) {
  using std::atan2;
  Jet<T, N, K> angle;
  if constexpr (K != 0) {
    const auto steep = farther_from_zero(y.c[0], x.c[0]);
    const Jet<T, N, K> numerator = select(steep, x, y), denominator = select(steep, y, x);
    const Jet<T, N, K> flat = atan(numerator / denominator);
    const Jet<T, N, K> regular = select(steep, -flat, flat);
    const auto above = equal(x.c[0], T(0.0)), beside = equal(y.c[0], T(0.0));
    angle = select(above, select(beside, Jet<T, N, K>(), regular), regular);
  }
  angle.c[0] = atan2(y.c[0], x.c[0]);
  return angle;
}
}  // namespace rfm
