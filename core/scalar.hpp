#pragma once

#include <algorithm>
#include <cmath>
#include <concepts>
#include <experimental/simd>

#include "core/interval.hpp"

namespace rfm {

/// A batch of numbers as wide as the machine's vectors: the hot path of tapes.
using Batch = std::experimental::native_simd<double>;
using BatchMask = Batch::mask_type;

/// Numbers, one or several at once, as opposed to bounds.
template <class T>
inline constexpr bool is_plain = std::floating_point<T> || std::same_as<T, Batch>;

// The rules of jets are written once for every kind of number: double, Batch, Interval,
// TaylorBound. What these do not share by name is brought together here: comparisons give a mask
// (bool, a lane mask, a Truth), and `select(mask, yes, no)` chooses by it. The select of a Batch
// takes each lane from its own side, so that a NaN on the side not chosen does no harm; the select
// of bounds encloses both sides where the truth is unknown.

inline bool less(double a, double b) { return a < b; }
inline bool less_equal(double a, double b) { return a <= b; }
inline bool equal(double a, double b) { return a == b; }
inline double select(bool condition, double yes, double no) { return condition ? yes : no; }
inline double square(double a) { return a * a; }

[[gnu::always_inline]] inline BatchMask less(const Batch& a, const Batch& b) { return a < b; }
[[gnu::always_inline]] inline BatchMask less_equal(const Batch& a, const Batch& b) {
  return a <= b;
}
[[gnu::always_inline]] inline BatchMask equal(const Batch& a, const Batch& b) { return a == b; }
[[gnu::always_inline]] inline Batch select(const BatchMask& condition, const Batch& yes,
                                           const Batch& no) {
  Batch chosen = no;
  std::experimental::where(condition, chosen) = yes;
  return chosen;
}
[[gnu::always_inline]] inline Batch square(const Batch& a) { return a * a; }

/// aᵉ as a plain number. Of −∞ that of other negative numbers: none unless e is whole.
inline double power(double a, double exponent) {
  return a < 0 && exponent != std::floor(exponent) ? std::numeric_limits<double>::quiet_NaN()
                                                   : std::pow(a, exponent);
}
inline Batch power(const Batch& a, const Batch& exponent) {
  const BatchMask has_none = a < 0.0 && exponent != std::experimental::floor(exponent);
  return select(has_none, Batch(std::numeric_limits<double>::quiet_NaN()),
                Batch(std::experimental::pow(a, exponent)));
}

/// The vector sine and cosine reduce their argument modulo π/2 with a quotient of 32 bits: beyond
/// that lanes are computed one by one.
inline Batch sin(const Batch& a) {
  if (std::experimental::none_of(std::experimental::abs(a) > 0x1p30))
    return std::experimental::sin(a);
  return Batch([&](auto lane) { return std::sin(a[lane]); });
}
inline Batch cos(const Batch& a) {
  if (std::experimental::none_of(std::experimental::abs(a) > 0x1p30))
    return std::experimental::cos(a);
  return Batch([&](auto lane) { return std::cos(a[lane]); });
}

inline bool any(bool condition) { return condition; }
inline bool any(const BatchMask& condition) { return std::experimental::any_of(condition); }

/// Whether a is farther from zero than b, so that it is the better divisor.
inline bool farther_from_zero(double a, double b) { return std::fabs(a) > std::fabs(b); }
inline BatchMask farther_from_zero(const Batch& a, const Batch& b) {
  return std::experimental::abs(a) > std::experimental::abs(b);
}

/// `value`, but NaN where `argument` is. Bounds speak of points where all is defined.
inline double nan_where_nan(double value, double argument) {
  return std::isnan(argument) ? argument : value;
}
inline Batch nan_where_nan(const Batch& value, const Batch& argument) {
  return select(argument == argument, value, argument);
}
inline const Interval& nan_where_nan(const Interval& value, const Interval&) { return value; }

/// a < b or a > b, and where a is NaN: so that `select(…, a, b)` is NaN wherever one of them is.
inline bool less_or_nan(double a, double b) { return a < b || std::isnan(a); }
inline bool greater_or_nan(double a, double b) { return a > b || std::isnan(a); }
inline BatchMask less_or_nan(const Batch& a, const Batch& b) { return a < b || a != a; }
inline BatchMask greater_or_nan(const Batch& a, const Batch& b) { return a > b || a != a; }
inline Truth less_or_nan(const Interval& a, const Interval& b) { return less(a, b); }
inline Truth greater_or_nan(const Interval& a, const Interval& b) { return less(b, a); }

/// a − b ⌊a / b⌋ without the rounding of the quotient: 0 or of the sign of b. Not for bounds.
template <std::floating_point Real>
inline Real floored_remainder(Real a, Real b) {
  const Real rest = std::fmod(a, b);
  return rest != 0 && (rest < 0) != (b < 0) ? rest + b : rest;
}
inline Batch floored_remainder(const Batch& a, const Batch& b) {
  return Batch([&](auto lane) { return floored_remainder<double>(a[lane], b[lane]); });
}

/// Whether 1/a is zero, not finite or has lost digits as a denormal.
template <std::floating_point Real>
bool has_no_reciprocal(Real a) {
  return !(std::fabs(a) > 0x1p-1020 && std::fabs(a) < 0x1p1020);
}
inline BatchMask has_no_reciprocal(const Batch& a) {
  const Batch size = std::experimental::abs(a);
  return !(size > Batch(0x1p-1020) && size < Batch(0x1p1020));
}
template <std::floating_point Real>
bool is_infinite(Real a) {
  return std::isinf(a);
}
inline BatchMask is_infinite(const Batch& a) { return std::experimental::isinf(a); }
/// Whether a, positive and finite, is so far from 1 that its powers would overflow or underflow.
template <std::floating_point Real>
bool is_far_from_one(Real a) {
  return (a > 0 && a < 0x1p-100) || (a > 0x1p100 && std::isfinite(a));
}
inline BatchMask is_far_from_one(const Batch& a) {
  return (a > Batch(0.0) && a < Batch(0x1p-100)) ||
         (a > Batch(0x1p100) && a < Batch(std::numeric_limits<double>::infinity()));
}
/// The largest e with 2^e ≤ |a|, −∞ for zero and for what is not finite.
template <std::floating_point Real>
Real binary_exponent(Real a) {
  return a == 0 || !std::isfinite(a) ? -std::numeric_limits<Real>::infinity()
                                     : static_cast<Real>(std::ilogb(a));
}
inline Batch binary_exponent(const Batch& a) {
  return Batch([&](auto lane) { return binary_exponent<double>(a[lane]); });
}
/// a b = whole + part, of which the first is a whole number and the second not far from its part of
/// the product before it is rounded, for whole numbers a.
inline double whole_of_product(double a, double b) { return std::nearbyint(a * b); }
inline double part_of_product(double a, double b) {
  return (a * b - whole_of_product(a, b)) + std::fma(a, b, -(a * b));
}
inline Batch whole_of_product(const Batch& a, double b) {
  return Batch([&](auto lane) { return whole_of_product(a[lane], b); });
}
inline Batch part_of_product(const Batch& a, double b) {
  return Batch([&](auto lane) { return part_of_product(a[lane], b); });
}
/// 2^e a, rounded once, e a whole number.
template <std::floating_point Real>
Real times_power_of_two(Real a, Real e) {
  return std::ldexp(a, static_cast<int>(std::clamp<Real>(e, -100000, 100000)));
}
inline Batch times_power_of_two(const Batch& a, const Batch& e) {
  return Batch([&](auto lane) { return times_power_of_two<double>(a[lane], e[lane]); });
}

/// √(1 + a²), also where the square overflows.
template <class T>
T length_with_one(const T& a) {
  return sqrt(T(1.0) + square(a));
}
template <std::floating_point Real>
Real length_with_one(const Real& a) {
  return std::hypot(Real(1), a);
}
inline Batch length_with_one(const Batch& a) {
  const Batch size = std::experimental::abs(a);
  return select(size > Batch(0x1p500), size, std::experimental::sqrt(Batch(1.0) + a * a));
}

/// 1 / a, or 0 where a = 0: derivatives at singular points are finite by convention (see jet.hpp).
template <class T>
T reciprocal_or_zero(const T& a) {
  return select(equal(a, T(0.0)), T(0.0), T(1.0) / a);
}

}  // namespace rfm
