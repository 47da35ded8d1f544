// Breakpoints of the outer axis at which the order of the breakpoints of sections changes.

#include <algorithm>
#include <cmath>

#include "quadrature/reduction_3d.hpp"

namespace rfm {
namespace {

using Breakpoint = Reduction2D::Breakpoint;

// The first breakpoint with a cause.
const Breakpoint* find_cause(const std::vector<Breakpoint>& breakpoints, int cause) {
  const auto place = std::ranges::find(breakpoints, cause, &Breakpoint::cause);
  return place == breakpoints.end() ? nullptr : &*place;
}

// The root of a function without known derivative: the Illinois variant of the false position.
// Where the function is not defined (NaN) the interval is halved.
template <class Function>
double bracketed_root_without_slope(Function&& function, double low, double high, double value_low,
                                    double value_high, double tolerance) {
  constexpr int max_steps = 60;
  int last_side = 0;
  for (int step = 0; step < max_steps && high - low > tolerance; ++step) {
    double t = (low * value_high - high * value_low) / (value_high - value_low);
    if (!(t > low && t < high) || step > 20) t = 0.5 * (low + high);
    const double value = function(t);
    if (std::isnan(value)) {
      // Beyond the end of one of the curves: keep the half in which both exist.
      high = t;
      continue;
    }
    if (std::fabs(value) == 0) return t;
    if ((value > 0) == (value_low > 0)) {
      low = t;
      value_low = value;
      if (last_side < 0) value_high *= 0.5;
      last_side = -1;
    } else {
      high = t;
      value_high = value;
      if (last_side > 0) value_low *= 0.5;
      last_side = 1;
    }
  }
  return 0.5 * (low + high);
}

}  // namespace

// A crossing of two graphs meets a third surface at vertices, and passes under or over traces of
// others. Ends of curves are breakpoints already: it remains to find where two curves change
// places, from their order near the ends and in the middle of every interval.
void Reduction3D::add_changes_of_order() {
  const auto is_curve = [](const Curve& curve) { return curve.meeting != Meeting::never; };
  const bool any = std::ranges::any_of(curves_, [&](const Curve& crossing) {
    return crossing.is_crossing && is_curve(crossing) &&
           std::ranges::any_of(curves_, [&](const Curve& other) {
             if (&other == &crossing || !is_curve(other)) return false;
             return other.is_crossing ||
                    (other.first != crossing.first && other.first != crossing.second);
           });
  });
  const auto is_isolated = [](const Curve& curve) { return curve.meeting == Meeting::unknown; };
  if (!any && std::ranges::none_of(curves_, is_isolated)) return;
  const auto causes_in = [&](double place) {
    std::vector<Breakpoint> causes = section(place).breakpoints();
    std::erase_if(causes, [](const Breakpoint& b) { return b.cause == Breakpoint::side_of_box; });
    return causes;
  };
  const double same = 1e-11 * box_.length(inner_);
  for (std::size_t k = 0; k + 1 < breakpoints_.size(); ++k) {
    const double from = breakpoints_[k], width = breakpoints_[k + 1] - from;
    if (width <= 1e-9 * box_.length(outer())) continue;
    const std::array<double, 3> places{from + 1e-7 * width, from + 0.5 * width,
                                       from + (1 - 1e-7) * width};
    std::array<std::vector<Breakpoint>, 3> orders;
    for (int i = 0; i < 3; ++i) orders[i] = causes_in(places[i]);
    // A crossing curve that was left to isolation is harmless where the surfaces only touch. Where
    // they cross, every section has to meet it in the same way, at most once; otherwise it turns or
    // branches somewhere in the box.
    for (const Curve& curve : curves_) {
      if (!is_isolated(curve) || !changes_sign(curve)) continue;
      std::array<long, 3> counts;
      for (int i = 0; i < 3; ++i)
        counts[i] = std::ranges::count(
            orders[i], Reduction2D::crossing_cause(curve.first, curve.second), &Breakpoint::cause);
      contacts_resolved_ &= counts[0] <= 1 && counts[0] == counts[1] && counts[1] == counts[2];
    }
    for (int i = 0; i < 2; ++i)
      for (std::size_t a = 0; a < orders[i].size(); ++a)
        for (std::size_t b = a + 1; b < orders[i].size(); ++b) {
          const int first = orders[i][a].cause, second = orders[i][b].cause;
          const Breakpoint* const later_first = find_cause(orders[i + 1], first);
          const Breakpoint* const later_second = find_cause(orders[i + 1], second);
          if (first == second || !later_first || !later_second) continue;
          const double before = orders[i][a].position - orders[i][b].position;
          const double after = later_first->position - later_second->position;
          if (!(before < -same && after > same)) continue;
          const auto difference = [&](double place) {
            const auto& now = section(place).breakpoints();
            const Breakpoint *const p = find_cause(now, first), *const q = find_cause(now, second);
            return p && q ? p->position - q->position : std::nan("");
          };
          found_.push_back(bracketed_root_without_slope(
              difference, places[i], places[i + 1], before, after, 1e-15 * box_.length(outer())));
        }
  }
  breakpoints_.insert(breakpoints_.end(), found_.begin(), found_.end());
  found_.clear();
  std::ranges::sort(breakpoints_);
}

// Whether samples of the difference of the heights of two graphs have both signs.
bool Reduction3D::changes_sign(const Curve& crossing) const {
  constexpr int samples = 5;
  const double same = 1e-12 * box_.length(height_);
  bool positive = false, negative = false;
  for (int i = 0; i < samples; ++i)
    for (int j = 0; j < samples; ++j) {
      LineSegment line{{}, height_, box_.low[height_], box_.high[height_]};
      line.through[outer()] = box_.low[outer()] + box_.length(outer()) * (i + 0.5) / samples;
      line.through[inner_] = box_.low[inner_] + box_.length(inner_) * (j + 0.5) / samples;
      const Crossing p = find_crossing(*active_->surfaces[crossing.first], line);
      const Crossing q = find_crossing(*active_->surfaces[crossing.second], line);
      if (!p.exists || !q.exists) continue;
      positive |= p.position - q.position > same;
      negative |= p.position - q.position < -same;
    }
  return positive && negative;
}

}  // namespace rfm
