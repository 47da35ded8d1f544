#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

namespace rfm {

/// Three-valued truth, for statements about a whole box.
enum class Truth : signed char { no = -1, unknown = 0, yes = 1 };

/// A closed interval [low, high] that encloses every value of a function over a box.
///
/// Outward rounding is by proven margin rather than by switching the rounding mode: each basic
/// operation has relative error ≤ 2⁻⁵³, so widening both ends by 2⁻⁵² of their size (plus the
/// smallest denormal where a result may have underflowed) encloses the exact result. The margin is
/// multiplicative so that the exact zero [0, 0] stays exact: a derivative that is identically zero
/// is recognised as structural independence. Elementary functions of the C library have errors
/// below 2 ulp; their margin is 4 ulp.
struct Interval {
  double low = 0;
  double high = 0;

  constexpr Interval() = default;
  constexpr Interval(double value) : low(value), high(value) {}  // NOLINT: numbers are intervals
  constexpr Interval(double low, double high) : low(low), high(high) {}

  static constexpr Interval entire() {
    return {-std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
  }
  double middle() const { return 0.5 * (low + high); }
  double radius() const { return 0.5 * (high - low); }
  double width() const { return high - low; }
  /// Largest absolute value.
  double magnitude() const { return std::max(std::fabs(low), std::fabs(high)); }
  /// Smallest absolute value.
  double mignitude() const { return low > 0 ? low : high < 0 ? -high : 0.0; }
  bool contains(double value) const { return low <= value && value <= high; }
  bool excludes_zero() const { return low > 0 || high < 0; }
  bool is_zero() const { return low == 0 && high == 0; }
  bool is_point() const { return low == high; }
};

Interval operator+(const Interval& a, const Interval& b);
Interval operator-(const Interval& a, const Interval& b);
Interval operator-(const Interval& a);
Interval operator*(const Interval& a, const Interval& b);
/// The entire line when `b` contains zero.
Interval operator/(const Interval& a, const Interval& b);

Interval square(const Interval& a);
Interval integer_power(const Interval& a, int exponent);
// Functions that are undefined in part of `a` are enclosed where they are defined (√, log, asin,
// acos, real powers); where that is nowhere, nothing is known: the entire line.

/// aᵉ for a ≥ 0.
Interval power(const Interval& a, double exponent);
Interval sqrt(const Interval& a);
Interval cbrt(const Interval& a);
Interval exp(const Interval& a);
Interval log(const Interval& a);
Interval sin(const Interval& a);
Interval cos(const Interval& a);
Interval tan(const Interval& a);
Interval asin(const Interval& a);
Interval acos(const Interval& a);
Interval atan(const Interval& a);
Interval atan2(const Interval& y, const Interval& x);
Interval sinh(const Interval& a);
Interval cosh(const Interval& a);
Interval tanh(const Interval& a);
Interval asinh(const Interval& a);
Interval erf(const Interval& a);
Interval abs(const Interval& a);
Interval floor(const Interval& a);
Interval hypot(const Interval& a, const Interval& b);

/// The common part; if rounding makes it empty, the narrower of the two.
Interval intersection(const Interval& a, const Interval& b);
Interval hull(const Interval& a, const Interval& b);

inline Truth less(const Interval& a, const Interval& b) {
  return a.high < b.low ? Truth::yes : a.low >= b.high ? Truth::no : Truth::unknown;
}
inline Truth less_equal(const Interval& a, const Interval& b) {
  return a.high <= b.low ? Truth::yes : a.low > b.high ? Truth::no : Truth::unknown;
}
inline Truth equal(const Interval& a, const Interval& b) {
  if (a.is_point() && b.is_point() && a.low == b.low) return Truth::yes;
  return a.high < b.low || b.high < a.low ? Truth::no : Truth::unknown;
}
/// Of two divisors the one whose smallest absolute value is the larger.
inline Truth farther_from_zero(const Interval& a, const Interval& b) {
  return a.mignitude() > b.mignitude() ? Truth::yes : Truth::no;
}
inline Interval select(Truth condition, const Interval& yes, const Interval& no) {
  return condition == Truth::yes ? yes : condition == Truth::no ? no : hull(yes, no);
}

}  // namespace rfm
