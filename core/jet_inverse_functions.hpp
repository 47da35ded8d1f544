#pragma once

#include <cmath>
#include <limits>

#include "core/jet_scaling.hpp"

namespace rfm {

// Inverse functions of jets: arcs and angles.

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

/// 1 − x² to 1.1 ulp, for powers of it: next to ±1 as a product, in which 1 − |x| is exact.
template <class T>
T rest_of_square(const T& x) {
  if constexpr (is_plain<T>) {
    using std::abs;
    const T size = abs(x);
    return select(less(size, T(0.5)), T(T(1.0) - x * x), T((T(1.0) - size) * (T(1.0) + size)));
  } else {
    return (T(1.0) - x) * (T(1.0) + x);
  }
}

template <class T, int N, int K>
Jet<T, N, K> asin(const Jet<T, N, K>& a) {
  using std::asin;
  if (a.order() == 0) return Jet<T, N, K>::constant(asin(a.c[0]));
  using std::sqrt;
  const T rest = rest_of_square(a.c[0]);  // the derivatives are 0 where it is, by convention
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

/// From z = 1/(a₀ − i): the k-th derivative of atan over k! is (−1)^{k−1} Im z^k / k. The products
/// of complex numbers do not cancel; far out increments are taken in units of |a₀|. Bounds have the
/// series of the integral of 1/(1 + a²).
template <class T, int N, int K>
Jet<T, N, K> atan(const Jet<T, N, K>& a) {
  using std::abs, std::atan;
  if (a.order() == 0) return Jet<T, N, K>::constant(atan(a.c[0]));
  if constexpr (is_plain<T>) {
    const T size = abs(a.c[0]);
    const auto far = less(T(0x1p30), size);
    const T unit = select(far, size, T(1.0)), x = a.c[0] / unit, y = T(1.0) / unit;
    const T inverse = T(1.0) / (x * x + y * y), real = x * inverse, imaginary = y * inverse;
    TaylorSeries<T, K> taylor;
    taylor[0] = atan(a.c[0]);
    T c = real, s = imaginary;  // z^k
    for (int k = 1; k <= a.order(); ++k) {
      taylor[k] = T((k % 2 == 1 ? 1.0 : -1.0) / k) * s;
      const T next = s * real + c * imaginary;
      c = c * real - s * imaginary;
      s = next;
    }
    return compose(in_units_of(unit, a), taylor);
  } else {
    const auto x = own_variable(a);
    const decltype(x) one(1.0);
    return compose_primitive(a, T(atan(a.c[0])), one / (one + x * x));
  }
}

/// With the length λ = √(1 + a₀²) and c = a₀/λ the coefficients in e = (a − a₀)/λ are those of the
/// integral of 1/√(1 + 2ce + e²), of which Legendre's polynomials P_k(−c) are the coefficients.
/// Their differences D_k = P_k − P_{k−1} at |c| follow from 1 − |c| where that is small.
template <class T, int K>
TaylorSeries<T, K> inverse_hyperbolic_sine_series(int order, const T& a, const T& length) {
  using std::abs, std::asinh;
  const T sine = T(1.0) / length, c = abs(T(a * sine)), rest = sine * sine / (T(1.0) + c);
  const T sign = select(less(a, T(0.0)), T(1.0), T(-1.0));
  const auto is_small = less(c, T(0.5));
  TaylorSeries<T, K> taylor;
  taylor[0] = asinh(a);
  T before = T(0.0), last = T(1.0), difference = T(0.0), factor = T(1.0);
  for (int k = 0; k < order; ++k) {
    taylor[k + 1] = T(1.0 / (k + 1)) * (factor * last);
    const T odd = T((2 * k + 1.0) / (k + 1)), even = T(k / (k + 1.0));
    difference = even * difference - odd * (rest * last);
    const T next = select(is_small, T(odd * (c * last) - even * before), T(last + difference));
    before = last;
    last = next;
    factor = factor * sign;
  }
  return taylor;
}

template <class T, int N, int K>
Jet<T, N, K> asinh(const Jet<T, N, K>& a) {
  using std::asinh;
  if (a.order() == 0) return Jet<T, N, K>::constant(asinh(a.c[0]));
  const T length = length_with_one(a.c[0]);
  if constexpr (is_plain<T>) {
    return compose(in_units_of(length, a),
                   inverse_hyperbolic_sine_series<T, K>(a.order(), a.c[0], length));
  } else {
    return compose(a, inverse_root_primitive<T, K>(a.order(), T(asinh(a.c[0])), T(T(1.0) / length),
                                                   a.c[0], T(T(-1.0) / (T(1.0) + square(a.c[0])))));
  }
}

/// The imaginary part of log z, z = x + iy, but for its value, as that of a real jet is made: with
/// e = z/z₀ it is e D(log z) = De. Where z₀ = 0 it is 0. Not for bounds.
template <class T, int N, int K>
Jet<T, N, K> regular_angle(const Jet<T, N, K>& y, const Jet<T, N, K>& x) {
  using std::abs, std::max;
  const T size = max(T(abs(x.c[0])), T(abs(y.c[0])));
  const T unit = select(equal(size, T(0.0)), T(1.0), size);
  const T c = x.c[0] / unit, s = y.c[0] / unit, inverse = reciprocal_or_zero(T(c * c + s * s));
  const Jet<T, N, K> u = in_units_of(unit, x), v = in_units_of(unit, y);
  Jet<T, N, K> real = scaled(T(c * inverse), u) + scaled(T(s * inverse), v);
  Jet<T, N, K> imaginary = scaled(T(c * inverse), v) - scaled(T(s * inverse), u);
  const Jet<T, N, K> opposite = -imaginary;
  Jet<T, N, K> real_slope = real, slope = imaginary, angle = imaginary;  // D(log z), log z
  for_each_derivative(angle, [&](auto i) {
    const double degree = degree_at(x, y, i);
    real_slope.c[i] = without_products(T(T(degree) * real.c[i]), real_slope, real, i);
    real_slope.c[i] = without_products(real_slope.c[i], slope, opposite, i);
    slope.c[i] = without_products(T(T(degree) * imaginary.c[i]), real_slope, imaginary, i);
    slope.c[i] = without_products(slope.c[i], slope, real, i);
    angle.c[i] = slope.c[i] * T(1 / degree);
  });
  return angle;
}

/// The angle of (x, y). Bounds have derivatives of atan(y/x) or of −atan(x/y), whichever quotient
/// is the smaller.
template <class T, int N, int K>
Jet<T, N, K> atan2(const Jet<T, N, K>& y, const Jet<T, N, K>& x) {
  using std::atan2;
  Jet<T, N, K> angle;
  if constexpr (K != 0 && is_plain<T>) {
    angle = regular_angle(y, x);
  } else if constexpr (K != 0) {
    const auto steep = farther_from_zero(y.c[0], x.c[0]);
    const Jet<T, N, K> numerator = select(steep, x, y), denominator = select(steep, y, x);
    const Jet<T, N, K> flat = atan(numerator / denominator);
    const Jet<T, N, K> regular = select(steep, -flat, flat);
    const auto above = equal(x.c[0], T(0.0)), beside = equal(y.c[0], T(0.0));
    angle = select(above, select(beside, Jet<T, N, K>(), regular), regular);
  }
  angle.c[0] = atan2(y.c[0], x.c[0]);
  if constexpr (is_plain<T>)  // infinite both, they have no direction
    angle.c[0] = select(is_infinite(x.c[0]) && is_infinite(y.c[0]),
                        T(std::numeric_limits<double>::quiet_NaN()), angle.c[0]);
  return angle;
}

}  // namespace rfm
