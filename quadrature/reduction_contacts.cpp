// Surfaces that touch each other or a side of the box: whether the order of two graphs, or the sign
// of a surface on the side, stays the same although no bounds of slopes prove it.

#include <algorithm>
#include <cmath>

#include "quadrature/reduction_3d.hpp"
#include "quadrature/sign_survey.hpp"

namespace rfm {
namespace {

// Of the height of the box: what is less is rounding.
constexpr double rounding = 1e-12;
// Of the height, for contacts with a side: sides of cells at the border of the grid, and the planes
// that bisect these, are moved by 2⁻⁴⁰ of the cell. Where a graph passes through the side by ε on a
// strip of width O(√ε) it is cut off at the side: an error of O(ε^1.5), and the whole graph is
// counted in the box that holds the rest of it.
constexpr double moved_side = 2e-11;
// Of the width of the box: to this extrema are sought.
constexpr double near = 1e-9;

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

// The difference of the heights of two graphs has the same sign, up to rounding, at its extrema.
// Sections in which they touch all along do not know it.
bool Reduction3D::only_touch(const Curve& crossing) {
  const int i = crossing.first, j = crossing.second;
  const Plane across{box_, outer(), height_};
  SignSurvey survey(
      [&](double place) {
        const Interval p = existence(i, place), q = existence(j, place);
        return Interval(std::max(p.low, q.low), std::min(p.high, q.high));
      },
      [&](double place, double inner, double& slope) {
        return height_difference(section_plane(place), section_graph(i, place),
                                 section_graph(j, place), inner, slope);
      },
      [&](double place, double inner) {
        double change = 0;
        height_difference(across, section_graph(i, inner), section_graph(j, inner), place, change);
        return change;
      },
      rounding * box_.length(height_), near * box_.length(inner_));
  survey.run(box_.interval(outer()));
  if (survey.positive() && survey.negative()) return false;
  if (survey.positive()) proofs_.higher[i] |= 1u << j;
  if (survey.negative()) proofs_.higher[j] |= 1u << i;
  return true;
}

// The sign of a surface on the bottom or the top where it may touch it but does not pass through:
// zero is its greatest or least value there, up to rounding. A box bisected in search of the trace
// would be followed along the contact to the bottom. The range of a quadric proves it; of other
// surfaces, extrema along sections in both directions are evidence. What vanishes everywhere has no
// sign here: a face on a side shared by boxes has to be counted once.
Truth Reduction3D::touching_sign(int surface, const Box& face, bool by_evidence) {
  const Surface& function = *active_->surfaces[surface];
  const double level = face.low[height_];
  const double slope = bounds_[surface].gradient[height_].mignitude();
  const double same = moved_side * box_.length(height_) * slope;
  if (!(same > 0)) return Truth::unknown;
  if (const QuadricEvaluator* quadric = function.quadric()) {
    constexpr double far = 1e4;
    const Interval range = quadric->Quadric::value_bounds(face);
    if (range.high <= same && range.low < -far * same) return Truth::no;
    if (range.low >= -same && range.high > far * same) return Truth::yes;
    return Truth::unknown;
  }
  if (!by_evidence) return Truth::unknown;
  // What is not near zero bisection will tell.
  constexpr double contact = 1e7;
  bool positive = false, negative = false;
  for (const auto& [across, along] : {std::pair{(height_ + 1) % 3, (height_ + 2) % 3},
                                      std::pair{(height_ + 2) % 3, (height_ + 1) % 3}}) {
    const auto at = [&, across = across, along = along](double place, double inner, int axis,
                                                        double& change) {
      work_done += function.cost().crossing;
      Point point{};
      point[height_] = level;
      point[across] = place;
      point[along] = inner;
      return function.value_and_slope(point, axis, change);
    };
    SignSurvey survey([&, along = along](double) { return box_.interval(along); },
                      [&, along = along](double place, double inner, double& change) {
                        return at(place, inner, along, change);
                      },
                      [&, across = across](double place, double inner) {
                        double change = 0;
                        at(place, inner, across, change);
                        return change;
                      },
                      same, near * box_.length(along));
    survey.run(box_.interval(across));
    positive |= survey.positive();
    negative |= survey.negative();
    if (positive == negative || survey.nearest() > contact * same) return Truth::unknown;
  }
  has_contacts_ = true;
  return positive ? Truth::yes : Truth::no;
}

}  // namespace rfm
