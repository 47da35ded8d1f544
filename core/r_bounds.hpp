#pragma once

#include <algorithm>
#include <type_traits>

#include "core/jet.hpp"
#include "core/jet_piecewise.hpp"
#include "core/taylor_bound.hpp"

namespace rfm {

// Bounds of R-functions. Conjunctions and disjunctions increase in both arguments: the range over a
// box of arguments is that between two of its corners.

template <class T>
inline constexpr bool is_bound = std::is_same_v<T, Interval> || std::is_same_v<T, TaylorBound>;

inline const Interval& range_of_bound(const Interval& a) { return a; }
inline const Interval& range_of_bound(const TaylorBound& a) { return a.range; }

/// Narrows bounds of f(a, b) to [f(a.low, b.low), f(a.high, b.high)] for an f that increases in
/// both arguments and has a relative error below 10⁻¹⁴.
template <class T, class Function>
T narrowed_to_corners(const T& bounds, const T& a, const T& b, const Function& function) {
  const Interval &x = range_of_bound(a), &y = range_of_bound(b);
  const auto margin = [](double value, double left, double right) {
    if (value == 0 && (left == 0 || right == 0)) return 0.0;
    return 1e-14 * std::fabs(value) + std::numeric_limits<double>::min();
  };
  if (!(x.magnitude() < 1e300 && y.magnitude() < 1e300)) return bounds;
  using Number = Jet<double, 1, 0>;
  const double low = function(Number(x.low), Number(y.low)).value();
  const double high = function(Number(x.high), Number(y.high)).value();
  return narrowed(bounds, {low - margin(low, x.low, y.low), high + margin(high, x.high, y.high)});
}

/// Narrows bounds of a function of which |f| ≤ |factor| min(|a|, |b|) is known, and that it has the
/// sign of factor · a b or is 0.
template <class T>
T narrowed_to_smaller(const T& bounds, const T& a, const T& b, double factor) {
  const Interval &x = range_of_bound(a), &y = range_of_bound(b);
  const double most = std::fabs(factor) * std::min(x.magnitude(), y.magnitude());
  const bool not_negative = (x.low >= 0 && y.low >= 0) || (x.high <= 0 && y.high <= 0);
  const bool not_positive = (x.low >= 0 && y.high <= 0) || (x.high <= 0 && y.low >= 0);
  return narrowed(bounds, {(factor > 0 ? not_negative : not_positive) ? 0 : -most,
                           (factor > 0 ? not_positive : not_negative) ? 0 : most});
}

// Where the branch of |a|, min and max is undecided, both branches bound the function; so does the
// range that follows from those of the arguments, and more tightly.

template <class T, int N, int K>
requires is_bound<T> Jet<T, N, K> abs(const Jet<T, N, K>& a) {
  Jet<T, N, K> result = select(less(a.c[0], T(0.0)), -a, a);
  result.c[0] = narrowed(result.c[0], abs(range_of_bound(a.c[0])));
  return result;
}

template <class T, int N, int K>
requires is_bound<T> Jet<T, N, K> min(const Jet<T, N, K>& a, const Jet<T, N, K>& b) {
  const Interval &x = range_of_bound(a.c[0]), &y = range_of_bound(b.c[0]);
  Jet<T, N, K> result = select(less_or_nan(b.c[0], a.c[0]), b, a);
  result.c[0] = narrowed(result.c[0], {std::min(x.low, y.low), std::min(x.high, y.high)});
  return result;
}

template <class T, int N, int K>
requires is_bound<T> Jet<T, N, K> max(const Jet<T, N, K>& a, const Jet<T, N, K>& b) {
  const Interval &x = range_of_bound(a.c[0]), &y = range_of_bound(b.c[0]);
  Jet<T, N, K> result = select(greater_or_nan(b.c[0], a.c[0]), b, a);
  result.c[0] = narrowed(result.c[0], {std::max(x.low, y.low), std::max(x.high, y.high)});
  return result;
}

}  // namespace rfm
