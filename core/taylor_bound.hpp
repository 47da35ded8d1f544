#pragma once

#include <array>

#include "core/interval.hpp"
#include "core/multi_index.hpp"

namespace rfm {

/// A first-order Taylor model with a plain range beside it: over the box |yᵢ| ≤ radiusᵢ around its
/// centre, a function lies in
///
///     value + slope · y + [−error, error]      and in      range .
///
/// After every operation the range is intersected with what the model gives, so that bounds are
/// never wider than plain intervals and of second order where the function is smooth. A function
/// f(a) uses f(a₀) + f′(a₀) d + f″(range) d²/2; where f″ is unbounded the model falls back to the
/// range. `smooth` turns false when an argument touches a point where an operation is not smooth.
///
/// The box is that of `TaylorBound::Frame` in force on the thread: models over different boxes must
/// not be mixed.
///
/// Rounding is covered by a margin of m = 2·10⁻¹⁵ ≈ 18 u of |value| + Σ|slope·radius| + error after
/// each operation (u = 2⁻⁵³), and the smallest normal number for what underflows. The worst case is
/// the product. Its value is rounded once: u |value|. A slope a₀bᵢ + b₀aᵢ has an error of 3/2 u
/// (|t| + |t′|), t and t′ its two terms times the radius; they may cancel, but |t| + |t′| =
/// |t + t′| + 2 min(|t|, |t′|) at most, and 2 min ≤ 2 √|t t′| ≤ |a₀ b₀| + |aᵢ bᵢ| rᵢ², of which the
/// first is the value and the second part of the error: 3/2 u (extent + 3 |value| + error) for
/// three axes. The error itself is a sum of products of positive numbers, of which the longest has
/// 12 roundings: 12 u error. Together 5.5 u |value| + 1.5 u extent + 13.5 u error < m.
struct TaylorBound {
  double value = 0;
  std::array<double, maximum_variables> slope{};
  double error = 0;
  Interval range;
  bool smooth = true;

  TaylorBound() = default;
  TaylorBound(double number) : value(number), range(number) {}  // NOLINT: numbers are models

  /// Sets the half sides of the box for the models made while it lives.
  class Frame {
   public:
    explicit Frame(const std::array<double, maximum_variables>& radius);
    ~Frame();
    Frame(const Frame&) = delete;
    Frame& operator=(const Frame&) = delete;

   private:
    std::array<double, maximum_variables> previous_;
  };
  /// A function of which only the range is known.
  static TaylorBound of_range(const Interval& range, bool smooth);
  /// The coordinate `axis` over [low, high].
  static TaylorBound coordinate(const Interval& interval, int axis);

  /// Largest |slope · y| over the box.
  double linear_extent() const;
  bool is_zero() const { return range.is_zero(); }
};

TaylorBound operator+(const TaylorBound& a, const TaylorBound& b);
TaylorBound operator-(const TaylorBound& a, const TaylorBound& b);
TaylorBound operator-(const TaylorBound& a);
TaylorBound operator*(const TaylorBound& a, const TaylorBound& b);
TaylorBound operator/(const TaylorBound& a, const TaylorBound& b);
TaylorBound& operator+=(TaylorBound& a, const TaylorBound& b);

TaylorBound square(const TaylorBound& a);
TaylorBound power(const TaylorBound& a, double exponent);
/// As for intervals (core/jet.hpp).
TaylorBound power_known_to(const TaylorBound& a, double exponent, double lost, double relative);
TaylorBound sqrt(const TaylorBound& a);
TaylorBound cbrt(const TaylorBound& a);
TaylorBound exp(const TaylorBound& a);
TaylorBound log(const TaylorBound& a);
TaylorBound sin(const TaylorBound& a);
TaylorBound cos(const TaylorBound& a);
TaylorBound tan(const TaylorBound& a);
TaylorBound asin(const TaylorBound& a);
TaylorBound acos(const TaylorBound& a);
TaylorBound atan(const TaylorBound& a);
TaylorBound atan2(const TaylorBound& y, const TaylorBound& x);
TaylorBound sinh(const TaylorBound& a);
TaylorBound cosh(const TaylorBound& a);
TaylorBound tanh(const TaylorBound& a);
TaylorBound asinh(const TaylorBound& a);
TaylorBound erf(const TaylorBound& a);
TaylorBound floor(const TaylorBound& a);

inline Truth less(const TaylorBound& a, const TaylorBound& b) { return less(a.range, b.range); }
inline Truth less_equal(const TaylorBound& a, const TaylorBound& b) {
  return less_equal(a.range, b.range);
}
inline Truth equal(const TaylorBound& a, const TaylorBound& b) { return equal(a.range, b.range); }
inline const TaylorBound& nan_where_nan(const TaylorBound& value, const TaylorBound&) {
  return value;
}
inline Truth less_or_nan(const TaylorBound& a, const TaylorBound& b) {
  return less(a.range, b.range);
}
inline Truth greater_or_nan(const TaylorBound& a, const TaylorBound& b) {
  return less(b.range, a.range);
}
/// The same function, of which it is also known that it lies in `range`.
TaylorBound narrowed(TaylorBound a, const Interval& range);
inline Interval narrowed(const Interval& a, const Interval& range) {
  return intersection(a, range);
}
/// Both sides, and no longer smooth, where the truth is unknown.
TaylorBound select(Truth condition, const TaylorBound& yes, const TaylorBound& no);
inline Truth farther_from_zero(const TaylorBound& a, const TaylorBound& b) {
  return farther_from_zero(a.range, b.range);
}

}  // namespace rfm
