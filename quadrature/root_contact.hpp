#pragma once

#include <algorithm>
#include <cmath>

namespace rfm {

/// What a function does where it is zero up to rounding on a part of an interval.
enum class Contact {
  /// It has the same sign on both sides.
  touches,
  /// It changes its sign.
  crosses,
  /// It vanishes on the part and not only up to a small value: two functions are the same there.
  vanishes
};

/// Tells what `function(t, slope)` does at the contact [from, to] in [low, high] found by
/// `RootIsolation`, where it is at most `zero`. What is less than `rounding` is nothing.
///
/// A contact of order k is as long as the k-th root of `zero`, and the function rises to `zero`
/// towards both ends of it, so that in its middle parts it would be far above rounding. Signs
/// beyond it are read where the function is more than `zero`; crossings nearer to the contact than
/// it is long may be missed.
template <class Function>
Contact classify_contact(Function&& function, double low, double high, double from, double to,
                         double zero, double rounding) {
  double slope = 0, largest = 0;
  for (const double t : {0.04, 0.31, 0.69, 0.96})
    largest = std::max(largest, std::fabs(function(from + t * (to - from), slope)));
  constexpr double short_contact = 1e-4;
  if (largest <= rounding && to - from >= short_contact * (high - low)) return Contact::vanishes;
  const auto sign_beyond = [&](double start, double end) {
    double step = std::max(to - from, 1e-9 * (high - low));
    for (;; step *= 2) {
      const bool last = step >= std::fabs(end - start);
      const double value = function(last ? end : start + std::copysign(step, end - start), slope);
      if (std::fabs(value) > zero) return value > 0 ? 1 : -1;
      if (last) return 0;
    }
  };
  return sign_beyond(from, low) * sign_beyond(to, high) < 0 ? Contact::crosses : Contact::touches;
}

}  // namespace rfm
