// Breakpoints of the outer axis at which two curves of the base plane meet, and the order of the
// breakpoints of sections changes.

#include <algorithm>
#include <cmath>

#include "core/quadric_pencil.hpp"
#include "quadrature/reduction_3d.hpp"

namespace rfm {

// A bottom trace may cross a top trace: then nothing meets in space, but the inner integral has a
// kink. So it has where a crossing of two graphs passes under or over a trace of a third. Where a
// crossing reaches a trace of its own surfaces it ends, as found from the traces.
bool Reduction3D::may_meet(const Curve& a, const Curve& b) const {
  if (a.meeting != Meeting::at_most_once || b.meeting != Meeting::at_most_once) return false;
  if (!a.is_crossing && !b.is_crossing) return a.first != b.first && !are_apart(a, b);
  if (a.is_crossing && b.is_crossing) return true;
  const Curve &crossing = a.is_crossing ? a : b, &trace = a.is_crossing ? b : a;
  return trace.first != crossing.first && trace.first != crossing.second;
}

// Traces on the same side of the box, of surfaces that vanish nowhere together there.
bool Reduction3D::are_apart(const Curve& a, const Curve& b) const {
  if (a.is_vertical || b.is_vertical || a.second != b.second) return false;
  Box face = box_;
  face.low[height_] = face.high[height_] = a.second == 0 ? box_.low[height_] : box_.high[height_];
  return rfm::are_apart(active_->surfaces[a.first]->quadric(),
                        active_->surfaces[b.first]->quadric(), face);
}

void Reduction3D::add_meetings(bool of_crossings) {
  middles_.clear();
  for (std::size_t a = 0; a < curves_.size(); ++a)
    for (std::size_t b = a + 1; b < curves_.size(); ++b)
      if ((curves_[a].is_crossing || curves_[b].is_crossing) == of_crossings &&
          may_meet(curves_[a], curves_[b]))
        add_meetings(a, b);
}

// Where a curve is in the middle of an interval between breakpoints: asked for by each pair.
const Reduction3D::CurvePoint& Reduction3D::middle_point(std::size_t curve, std::size_t interval) {
  if (middles_.empty()) middles_.resize(curves_.size() * (breakpoints_.size() - 1));
  std::optional<CurvePoint>& point = middles_[curve * (breakpoints_.size() - 1) + interval];
  if (!point)
    point =
        curve_point(curves_[curve], 0.5 * (breakpoints_[interval] + breakpoints_[interval + 1]));
  return *point;
}

// Between neighbouring breakpoints both curves exist throughout or one of them nowhere.
void Reduction3D::add_meetings(std::size_t first, std::size_t second) {
  const Curve &a = curves_[first], &b = curves_[second];
  const auto difference = [&](double place, double& slope) {
    const CurvePoint p = curve_point(a, place), q = curve_point(b, place);
    slope = p.slope - q.slope;
    return p.position - q.position;
  };
  const auto slopes = [&](double from, double to) {
    return slope_bounds(a, from, to) - slope_bounds(b, from, to);
  };
  const Interval whole_slope = a.slope - b.slope;
  const double zero = 1e-13 * box_.length(inner_);
  for (std::size_t k = 0; k + 1 < breakpoints_.size(); ++k) {
    const double from = breakpoints_[k], to = breakpoints_[k + 1];
    if (to - from <= negligible_width()) continue;
    const CurvePoint& p = middle_point(first, k);
    if (!p.exists) continue;
    const CurvePoint& q = middle_point(second, k);
    if (!q.exists ||
        std::fabs(p.position - q.position) > whole_slope.magnitude() * 0.5 * (to - from))
      continue;
    const auto add = [&](double root) { found_.push_back(root); };
    const auto add_contact = [&](double low, double high) {
      switch (classify_contact(difference, from, to, low, high, zero, base_plane().rounding())) {
        case Contact::touches:
          return this->add_contact(low, high);
        case Contact::crosses:
          return add(0.5 * (low + high));
        case Contact::vanishes:
          if (low > from) add(low);
          if (high < to) add(high);
      }
    };
    IsolationBudget budget;
    isolate_roots(difference, slopes, from, to, zero, add, add_contact, budget);
    certified_ &= !budget.exhausted;
  }
  add_found_meetings();
}

// Where two curves touch the section would take their surfaces for one. A breakpoint there, or one
// that is as near as rounding tells, keeps nodes of rules away from it.
void Reduction3D::add_contact(double low, double high) {
  for (const double place : breakpoints_)
    if (low <= place && place <= high) return contacts_.push_back(place);
  contacts_.push_back(0.5 * (low + high));
  found_.push_back(contacts_.back());
}

void Reduction3D::add_found_meetings() {
  if (found_.empty()) return;
  // Three curves through one point meet in pairs, at the same place up to rounding. The integrand
  // has a kink there: to move it by ε is an error of O(ε²).
  const double same = 1e-11 * box_.length(outer());
  for (const double place : found_)
    if (std::ranges::none_of(breakpoints_,
                             [&](double other) { return std::fabs(other - place) <= same; }))
      breakpoints_.push_back(place);
  found_.clear();
  middles_.clear();
  std::ranges::sort(breakpoints_);
}

}  // namespace rfm
