#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

namespace rfm {

/// Three-valued truth, for statements about a whole box.
enum class Truth : signed char { no = -1, unknown = 0, yes = 1 };

/// A closed interval [low, high] that encloses every value of a function over a box.
///
/// Outward rounding is by proven margin rather than by switching the rounding mode. With u = 2⁻⁵³:
///
/// - Basic operations (+ − · / √) are rounded to nearest, r̂ = fl(r), and their ends are moved to
///   fl(r̂ − 2u |r̂|) and fl(r̂ + 2u |r̂|). For a normal r̂, 2u |r̂| is exact and at least one unit in
///   the last place, so that r̂ − 2u |r̂| is at most the number before r̂, rounding is monotonic and
///   keeps it there, and r lies at most half a unit from r̂: the end is at or beyond r. Where the
///   compiler contracts a product and the margin into fl(r − 2u |r̂|), which −march=x86-64-v3
///   allows, r itself is moved by a unit and then rounded by at most half of one: beyond r too.
/// - Below the normal numbers the error of a rounding is at most one denormal, which is added.
/// - Functions of the C library have relative margins of 8u, and cbrt, whose bound is wider, of
///   16u. A unit in the last place is at most 2u |r̂|, and the end loses one u to its own rounding,
///   so that these cover errors of 3.5 and 7.5 units. The GNU C Library documents at most 2 for the
///   functions used here and 4 for cbrt ("Known Maximum Errors in Math Functions" in its manual);
///   the largest errors known are 2.2 (tanh) and 3.7 (cbrt) (Gladman, Innocente, Mather,
///   Zimmermann: Accuracy of Mathematical Functions in Single, Double, ... Precision). Only its
///   scalar functions are called here: the vector ones have wider errors.
///
/// The margin is multiplicative so that the exact zero [0, 0] stays exact: a derivative that is
/// identically zero is recognised as structural independence. Hence results that are not zero but
/// underflow are widened by a denormal. Ends are never NaN if those of the arguments are not.
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
// Of functions that may be no number somewhere in `a` (√, log, asin, acos, real powers) nothing is
// known, the entire line, so that nothing is proved of them there; rounding of `a` does not count.

/// aᵉ for a ≥ 0.
Interval power(const Interval& a, double exponent);
/// The relative error of aᵉ over a range of positive numbers where e is known up to `lost` (small)
/// and a factor beside it up to `relative`.
double error_of_power(const Interval& a, double relative, double lost);
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
