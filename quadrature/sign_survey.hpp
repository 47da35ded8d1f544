#pragma once

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/interval.hpp"

namespace rfm {

/// Which signs a function f of two variables takes beyond rounding, read off its extrema along
/// sections across the outer axis, and from the extrema of these from section to section. Evidence
/// and not proof: several sections are looked at, and two extrema between neighbours, or two within
/// one section, could be missed. The function is given by
///
///     extent(outer)                  where it is defined in a section; nowhere if low ≥ high
///     value(outer, inner, slope)     f and ∂f/∂inner
///     change(outer, inner)           ∂f/∂outer .
template <class Extent, class Value, class Change>
class SignSurvey {
 public:
  /// Values up to `same` are zero; extrema within a section are sought to `inner_tolerance`.
  SignSurvey(Extent extent, Value value, Change change, double same, double inner_tolerance)
      : extent_(extent),
        value_(value),
        change_(change),
        same_(same),
        inner_tolerance_(inner_tolerance) {}

  /// Ends early when both signs are found.
  void run(const Interval& outer) {
    constexpr int sections = 8;
    outer_tolerance_ = 1e-9 * outer.width();
    std::optional<double> before;
    double last = 0;
    for (int k = 0; k <= sections && !(positive_ && negative_); ++k) {
      const double place = outer.low + outer.width() * k / sections;
      const std::optional<double> change = visit(place);
      if (before && change) compare(last, *before, place, *change);
      if (k > 0 && before && !change) follow(last, *before, place);
      if (k > 0 && !before && change) follow(place, *change, last);
      before = change;
      last = place;
    }
  }

  bool positive() const { return positive_; }
  bool negative() const { return negative_; }
  /// The smallest |f| that was seen.
  double nearest() const { return nearest_; }

 private:
  // Takes note of the extreme along a section and returns how it changes from section to section.
  std::optional<double> visit(double place) {
    const Interval inner = extent_(place);
    if (!(inner.low < inner.high)) return {};
    double value_there = 0;
    const auto slope_at = [&](double t) {
      double slope = 0;
      value_there = value_(place, t, slope);
      positive_ |= value_there > same_;
      negative_ |= value_there < -same_;
      nearest_ = std::min(nearest_, std::fabs(value_there));
      return slope;
    };
    const double at_low = slope_at(inner.low), value_low = value_there;
    const double at_high = slope_at(inner.high), value_high = value_there;
    // Where |f| is least: inside, or at an end of the section.
    double extreme = std::fabs(value_low) < std::fabs(value_high) ? inner.low : inner.high;
    if ((at_low > 0) != (at_high > 0))
      extreme = sign_change(slope_at, inner.low, inner.high, at_low, at_high, inner_tolerance_);
    return change_(place, extreme);
  }

  // Extrema from section to section show as changes of sign of the change.
  void compare(double from, double change_from, double to, double change_to) {
    if ((change_from > 0) != (change_to > 0))
      sign_change([&](double t) { return visit(t).value_or(0); }, from, to, change_from, change_to,
                  outer_tolerance_);
  }

  // To where sections in which the function is defined end between `inside` and `outside`.
  void follow(double inside, double change, double outside) {
    constexpr int bisections = 30;
    double last = inside, last_change = change;
    for (int step = 0; step < bisections; ++step) {
      const double middle = 0.5 * (last + outside);
      if (const auto there = visit(middle))
        last = middle, last_change = *there;
      else
        outside = middle;
    }
    if (inside < last)
      compare(inside, change, last, last_change);
    else
      compare(last, last_change, inside, change);
  }

  // A sign change of `function` by bisection with false position (Illinois), to `tolerance`.
  template <class Function>
  static double sign_change(Function&& function, double low, double high, double value_low,
                            double value_high, double tolerance) {
    constexpr int max_steps = 60;
    int last_side = 0;
    for (int step = 0; step < max_steps && high - low > tolerance; ++step) {
      double t = (low * value_high - high * value_low) / (value_high - value_low);
      if (!(t > low && t < high) || step > max_steps / 3) t = 0.5 * (low + high);
      const double value = function(t);
      if (value == 0) return t;
      const bool is_low = (value > 0) == (value_low > 0);
      (is_low ? low : high) = t;
      (is_low ? value_low : value_high) = value;
      if (is_low && last_side < 0) value_high *= 0.5;
      if (!is_low && last_side > 0) value_low *= 0.5;
      last_side = is_low ? -1 : 1;
    }
    return 0.5 * (low + high);
  }

  Extent extent_;
  Value value_;
  Change change_;
  double same_;
  double inner_tolerance_, outer_tolerance_ = 0;
  bool positive_ = false, negative_ = false;
  double nearest_ = INFINITY;
};

}  // namespace rfm
