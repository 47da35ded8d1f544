#pragma once

#include <algorithm>
#include <cmath>

#include "core/interval.hpp"
#include "quadrature/work.hpp"

namespace rfm {

/// The root between `low` and `high` of a function with different signs there (sign(0) = +):
/// Newton's method kept in the bracket by bisection. `function(t, slope)` returns the value at t.
/// A step below 1e-8 of the bracket is the last: the error after it is its square.
template <class Function>
double bracketed_root(Function&& function, double low, double high, double value_low,
                      double value_high) {
  constexpr double last_step = 1e-8;
  constexpr int free_steps = 2, max_steps = 100;
  const bool positive_low = value_low >= 0;
  const double length = high - low, start_low = low, start_high = high;
  double t = low - value_low * length / (value_high - value_low);
  if (!(t > low && t < high)) t = 0.5 * (low + high);
  double previous = length;
  for (int step = 0; step < max_steps; ++step) {
    double slope = 0;
    const double value = function(t, slope);
    if (value == 0) return t;
    ((value >= 0) == positive_low ? low : high) = t;
    double change = -value / slope;
    if (std::fabs(change) < last_step * length)
      return std::clamp(t + change, start_low, start_high);
    // Steps that leave the bracket or do not halve bisect instead (also NaN).
    if (!(t + change > low && t + change < high) ||
        (step > free_steps && std::fabs(change) > 0.5 * std::fabs(previous)))
      change = 0.5 * (low + high) - t;
    previous = change;
    if (t + change == t || !(high - low > 0)) return t;
    t += change;
  }
  return t;
}

/// What isolation may cost, within the `last_work` of the thread; what it did not resolve.
struct IsolationBudget {
  int calls = 300;
  int max_depth = 24;
  /// Some interval was given up: roots may be missing there.
  bool exhausted = false;
};

/// All roots of a function on an interval where it changes sign, and its tangential contacts with
/// zero. An interval is settled when `slope_bounds(low, high)` excludes zero (at most one root) or
/// when |f| at its middle exceeds what the slope can bridge (none); it is bisected otherwise. Where
/// the function is at most `zero` at both ends and the middle it touches zero or coincides with it.
/// Neighbouring intervals of this kind are one contact, reported by its ends; nothing is reported
/// for a function that vanishes everywhere.
template <class Function, class SlopeBounds, class Report, class ReportContact>
class RootIsolation {
 public:
  RootIsolation(Function& function, SlopeBounds& slope_bounds, Report& report,
                ReportContact& report_contact, double zero, IsolationBudget& budget)
      : function_(function),
        slope_bounds_(slope_bounds),
        report_(report),
        report_contact_(report_contact),
        zero_(zero),
        budget_(budget) {}

  void run(double low, double high) {
    low_ = low;
    high_ = high;
    double slope = 0;
    const double value_low = function_(low, slope);
    visit(low, high, value_low, function_(high, slope), 0);
    finish_contact();
  }

 private:
  void visit(double low, double high, double value_low, double value_high, int depth) {
    const bool changes_sign = (value_low >= 0) != (value_high >= 0);
    const auto report_sign_change = [&] {
      if (changes_sign) report_(bracketed_root(function_, low, high, value_low, value_high));
    };
    if (--budget_.calls < 0 || work_done > last_work) {
      budget_.exhausted = true;
      return report_sign_change();
    }
    const Interval slopes = slope_bounds_(low, high);
    if (slopes.excludes_zero()) return report_sign_change();
    const double middle = 0.5 * (low + high);
    double slope = 0;
    const double value_middle = function_(middle, slope);
    if (std::fabs(value_middle) > slopes.magnitude() * 0.5 * (high - low)) return;
    if (std::fabs(value_low) <= zero_ && std::fabs(value_middle) <= zero_ &&
        std::fabs(value_high) <= zero_)
      return extend_contact(low, high);
    if (depth >= budget_.max_depth) {
      budget_.exhausted = true;
      return changes_sign ? report_sign_change() : extend_contact(low, high);
    }
    visit(low, middle, value_low, value_middle, depth + 1);
    visit(middle, high, value_middle, value_high, depth + 1);
  }

  void extend_contact(double low, double high) {
    if (!in_contact_ || low != contact_high_) {
      finish_contact();
      contact_low_ = low;
    }
    in_contact_ = true;
    contact_high_ = high;
  }

  void finish_contact() {
    if (!in_contact_) return;
    in_contact_ = false;
    if (contact_low_ > low_ || contact_high_ < high_) report_contact_(contact_low_, contact_high_);
  }

  Function& function_;
  SlopeBounds& slope_bounds_;
  Report& report_;
  ReportContact& report_contact_;
  double zero_;
  IsolationBudget& budget_;
  double low_ = 0, high_ = 0;
  bool in_contact_ = false;
  double contact_low_ = 0, contact_high_ = 0;
};

/// Calls `report(root)` for the roots of `function(t, slope)` on [low, high], and
/// `report_contact(from, to)` where it touches zero; see `RootIsolation`.
template <class Function, class SlopeBounds, class Report, class ReportContact>
void isolate_roots(Function&& function, SlopeBounds&& slope_bounds, double low, double high,
                   double zero, Report&& report, ReportContact&& report_contact,
                   IsolationBudget& budget) {
  RootIsolation(function, slope_bounds, report, report_contact, zero, budget).run(low, high);
}

/// The same where contacts are reported as roots: a short one by its middle, a longer one by its
/// ends within the interval.
template <class Function, class SlopeBounds, class Report>
void isolate_roots(Function&& function, SlopeBounds&& slope_bounds, double low, double high,
                   double zero, Report&& report, IsolationBudget& budget) {
  constexpr double short_contact = 1e-4;
  isolate_roots(
      function, slope_bounds, low, high, zero, report,
      [&](double from, double to) {
        if (to - from < short_contact * (high - low)) return report(0.5 * (from + to));
        if (from > low) report(from);
        if (to < high) report(to);
      },
      budget);
}

}  // namespace rfm
