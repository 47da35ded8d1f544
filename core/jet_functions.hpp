#pragma once

#include <cmath>
#include <limits>
#include <numbers>

#include "core/jet_scaling.hpp"

namespace rfm {

// Elementary functions of jets but powers (core/jet_powers.hpp) and inverse functions of circular
// and hyperbolic ones (core/jet_inverse_functions.hpp). Most are composed with their argument by
// their own Taylor coefficients at the value there. Where these may overflow or underflow although
// the increments of the argument make up for it, as for large arguments of a logarithm, increments
// are taken in units of the value or of a length.

/// √a = r by r² = a, coefficient by coefficient in ascending degree. At a = 0 they are 0.
template <class T, int N, int K>
Jet<T, N, K> sqrt(const Jet<T, N, K>& a) {
  using std::sqrt;
  Jet<T, N, K> root = constant_like(a, T(sqrt(a.c[0])));
  if (a.order() == 0) return root;
  const T inverse = select(equal(a.c[0], T(0.0)), T(0.0), T(0.5) / root.c[0]);
  Jet<T, N, K> relative = root;  // r / 2r₀
  for_each_derivative(a, [&](auto i) {
    root.c[i] = without_products(T(a.c[i] * inverse), relative, root, i);
    relative.c[i] = root.c[i] * inverse;
  });
  return root;
}

/// ∛a = r by r³ = a: with ρ = r/r₀ and σ = ρ², r_α = a_α/3r₀² − Σ ⅓r_β (ρ + σ)_{α−β}, 0 < β < α.
/// At a = 0 the coefficients are 0.
template <class T, int N, int K>
Jet<T, N, K> cbrt(const Jet<T, N, K>& a) {
  using std::cbrt;
  Jet<T, N, K> root = constant_like(a, T(cbrt(a.c[0])));
  if (a.order() == 0) return root;
  const T unit = reciprocal_or_zero(root.c[0]);
  const T inverse = select(equal(a.c[0], T(0.0)), T(0.0), T(1.0 / 3) * root.c[0] / a.c[0]);
  Jet<T, N, K> third = root, relative = root, sum = root;  // ⅓r, ρ, ρ + σ
  for_each_derivative(a, [&](auto i) {
    root.c[i] = without_products(T(a.c[i] * inverse), third, sum, i);
    third.c[i] = root.c[i] * T(1.0 / 3);
    relative.c[i] = root.c[i] * unit;
    sum.c[i] = T(3.0) * relative.c[i] - without_products(T(0.0), relative, relative, i);
  });
  return root;
}

template <class T, int N, int K>
Jet<T, N, K> exp(const Jet<T, N, K>& a) {
  using std::exp;
  TaylorSeries<T, K> taylor;
  taylor[0] = exp(a.c[0]);
  for (int k = 1; k <= a.order(); ++k) taylor[k] = taylor[k - 1] * T(1.0 / k);
  return compose(a, taylor);
}

/// log a by its derivative: with e = a/a₀ and D the sum over all variables x of x ∂/∂x, which
/// multiplies coefficients by their degree, e D(log a) = De.
template <class T, int N, int K>
Jet<T, N, K> log(const Jet<T, N, K>& a) {
  using std::log;
  Jet<T, N, K> result = constant_like(a, T(log(a.c[0])));
  if (a.order() == 0) return result;
  // Where the logarithm is not defined its derivatives are not either.
  T unit = a.c[0];
  if constexpr (is_plain<T>)
    unit = select(less(T(0.0), unit), unit, T(std::numeric_limits<double>::quiet_NaN()));
  const Jet<T, N, K> e = in_units_of(unit, a);
  Jet<T, N, K> slope = e;
  for_each_derivative(a, [&](auto i) {
    const double degree = degree_at(a, a, i);
    slope.c[i] = without_products(T(T(degree) * e.c[i]), slope, e, i);
    result.c[i] = slope.c[i] * T(1 / degree);
  });
  return result;
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
    T sum = taylor[0] * taylor[k];
    for (int i = 1; 2 * i < k; ++i) sum = sum + taylor[i] * taylor[k - i];
    sum = sum + sum;
    if (k % 2 == 0) sum = sum + square(taylor[k / 2]);
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

}  // namespace rfm
