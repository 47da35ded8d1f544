// Surfaces that touch: whether the order of two graphs stays the same although no bounds prove it.

#include <algorithm>
#include <cmath>
#include <optional>

#include "quadrature/reduction_3d.hpp"

namespace rfm {
namespace {

// A sign change of `function` by bisection with false position (Illinois), to `tolerance`.
template <class Function>
double sign_change(Function&& function, double low, double high, double value_low,
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

}  // namespace

// Every pair of graphs for which neither axis proves a crossing curve; true if each only touches.
bool Reduction3D::accept_contacts() {
  bool accepted = true;
  for (Curve& curve : curves_) {
    if (curve.meeting != Meeting::unknown) continue;
    if (only_touch(curve)) {
      curve.meeting = proofs_.crossings[curve.first][curve.second] = Meeting::never;
      has_contacts_ = true;
    } else {
      accepted = false;
    }
  }
  return accepted;
}

// The difference of the heights of two graphs has the same sign, up to rounding, at its extrema
// along sections, and at the extrema of these from section to section. Several sections are looked
// at; two extrema between neighbours could be missed.
bool Reduction3D::only_touch(const Curve& crossing) const {
  constexpr int sections = 8;
  const double same = 1e-12 * box_.length(height_);
  const int i = crossing.first, j = crossing.second;
  bool positive = false, negative = false;
  // Takes note of the extreme along a section and returns how it changes from section to section.
  const auto visit = [&](double place) -> std::optional<double> {
    const Interval p = existence(i, place), q = existence(j, place);
    const double low = std::max(p.low, q.low), high = std::min(p.high, q.high);
    if (!(low < high)) return {};
    const Plane plane = section_plane(place);
    const PlaneGraph first = section_graph(i, place), second = section_graph(j, place);
    double value_there = 0;
    const auto slope_at = [&](double inner) {
      double slope = 0;
      value_there = height_difference(plane, first, second, inner, slope);
      positive |= value_there > same;
      negative |= value_there < -same;
      return slope;
    };
    const double at_low = slope_at(low), value_low = value_there;
    const double at_high = slope_at(high), value_high = value_there;
    // Where the difference is least: inside, or at an end of the section.
    double extreme = std::fabs(value_low) < std::fabs(value_high) ? low : high;
    if ((at_low > 0) != (at_high > 0))
      extreme = sign_change(slope_at, low, high, at_low, at_high, 1e-9 * box_.length(inner_));
    double change = 0;
    const Plane across{box_, outer(), height_};
    height_difference(across, section_graph(i, extreme), section_graph(j, extreme), place, change);
    return change;
  };
  // Extrema from section to section show as changes of sign of the change.
  const auto compare = [&](double from, double change_from, double to, double change_to) {
    if ((change_from > 0) != (change_to > 0))
      sign_change([&](double t) { return visit(t).value_or(0); }, from, to, change_from, change_to,
                  1e-9 * box_.length(outer()));
  };
  // Where sections with both graphs end between `inside` and `outside`, by bisection.
  const auto follow = [&](double inside, double change, double outside) {
    double last = inside, last_change = change;
    for (int step = 0; step < 30; ++step) {
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
  };
  std::optional<double> before;
  double last = 0;
  for (int k = 0; k <= sections; ++k) {
    const double place = box_.low[outer()] + box_.length(outer()) * k / sections;
    const std::optional<double> change = visit(place);
    if (before && change) compare(last, *before, place, *change);
    if (k > 0 && before && !change) follow(last, *before, place);
    if (k > 0 && !before && change) follow(place, *change, last);
    before = change;
    last = place;
    if (positive && negative) return false;
  }
  return true;
}

}  // namespace rfm
