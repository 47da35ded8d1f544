// The curves of the base plane along which breakpoints of sections move, and the choice of the
// inner axis over which they are graphs.

#include <algorithm>
#include <cmath>

#include "core/quadric_pencil.hpp"
#include "quadrature/reduction_3d.hpp"

namespace rfm {

// The sign of a surface on the bottom or the top, and its trace there if it has none. Where the
// surface is monotone in both base axes the signs at two opposite corners decide.
Truth Reduction3D::add_trace(int surface, int end, bool tight, bool by_evidence) {
  Truth sign;
  const double level = end == 0 ? box_.low[height_] : box_.high[height_];
  const int a = (height_ + 1) % 3, b = (height_ + 2) % 3;
  const auto& whole = bounds_[surface].gradient;
  const auto is_monotone = [](const Interval& slope) {
    return slope.excludes_zero() || slope.is_zero();
  };
  FunctionBounds& trace = traces_[surface][end];
  if (!tight && is_monotone(whole[a]) && is_monotone(whole[b])) {
    trace = bounds_[surface];
    Point least{}, most{};
    least[height_] = most[height_] = level;
    for (const int axis : {a, b}) {
      least[axis] = whole[axis].low >= 0 ? box_.low[axis] : box_.high[axis];
      most[axis] = whole[axis].low >= 0 ? box_.high[axis] : box_.low[axis];
    }
    sign = active_->surfaces[surface]->value(least) >= 0  ? Truth::yes
           : active_->surfaces[surface]->value(most) >= 0 ? Truth::unknown
                                                          : Truth::no;
  } else {
    Box face = box_;
    face.low[height_] = face.high[height_] = level;
    trace = active_->surfaces[surface]->bounds(face);
    sign = trace.value.low >= 0 ? Truth::yes : trace.value.high < 0 ? Truth::no : Truth::unknown;
    // An extreme of zero, in a point or along a curve, is one for all directions.
    if (sign == Truth::unknown && !trace.gradient[a].excludes_zero() &&
        !trace.gradient[b].excludes_zero()) {
      sign = touching_sign(surface, face, by_evidence);
      if (sign != Truth::unknown) {
        touching_[end].known |= 1u << surface;
        if (sign == Truth::yes) touching_[end].positive |= 1u << surface;
      }
    }
  }
  if (sign != Truth::unknown) return sign;
  Curve curve;
  curve.gradient = trace.gradient;
  curve.first = surface;
  curve.second = end;
  curves_.push_back(curve);
  return sign;
}

// The traces, and the surfaces that do not depend on the height; false if a surface turns out to
// have one sign.
bool Reduction3D::find_traces(bool tight, const Options& options) {
  curves_.clear();
  touching_ = {};
  bool all_change_sign = true;
  for (int i = 0; i < active_->count; ++i) {
    if (is_vertical(i)) {
      Curve curve;
      curve.gradient = bounds_[i].gradient;
      curve.first = i;
      curve.is_vertical = true;
      curves_.push_back(curve);
      continue;
    }
    std::array<Truth, 2>& signs = end_signs_[i];
    for (int end = 0; end < 2; ++end) signs[end] = add_trace(i, end, tight, options.allow_contacts);
    if (signs[0] != Truth::unknown && signs[0] == signs[1]) {
      constant_surface_ = i;
      constant_sign_ = signs[0] == Truth::yes;
      all_change_sign = false;
    }
  }
  return all_change_sign;
}

// The heights of a graph by an interval Newton step from its height at the centre: for a root (p,
// z) of w, 0 = w(c) + Σ ∂w (p − c) + ∂w/∂z (z − z_c) with derivatives somewhere in the box. A tall
// box would otherwise spoil the bounds of crossing curves, and no bisection of the base would mend
// them.
void Reduction3D::narrow_graphs() {
  for (int i = 0; i < active_->count; ++i) {
    if (is_vertical(i)) continue;
    const auto& gradient = bounds_[i].gradient;
    const LineSegment line{box_.center(), height_, box_.low[height_], box_.high[height_]};
    const double height = find_crossing(*active_->surfaces[i], line).position;
    Interval change = active_->surfaces[i]->value(line.at(height));
    for (int axis = 0; axis < 3; ++axis)
      if (axis != height_)
        change =
            change + gradient[axis] * Interval(-0.5 * box_.length(axis), 0.5 * box_.length(axis));
    ranges_[i] =
        intersection(Interval(height) - change / gradient[height_], box_.interval(height_));
    Box narrow = box_;
    narrow.low[height_] = std::max(ranges_[i].low, box_.low[height_]);
    narrow.high[height_] = std::min(ranges_[i].high, box_.high[height_]);
    narrow_[i] = bounds_[i];
    if (narrow.length(height_) < 0.7 * box_.length(height_) && narrow.length(height_) >= 0)
      narrow_[i] = active_->surfaces[i]->bounds(narrow);
  }
}

void Reduction3D::add_crossing_curves() {
  for (int i = 0; i < active_->count; ++i)
    for (int j = i + 1; j < active_->count; ++j) {
      if (is_vertical(i) || is_vertical(j) || proven_apart(i, j) ||
          rfm::are_apart(active_->surfaces[i]->quadric(), active_->surfaces[j]->quadric(), box_) ||
          coincide(i, j))
        continue;
      const auto &p = narrow_[i].gradient, &q = narrow_[j].gradient;
      Curve curve;
      // ∇(h_i − h_j) times the product of the height derivatives.
      for (int axis = 0; axis < 3; ++axis)
        if (axis != height_) curve.gradient[axis] = q[axis] * p[height_] - q[height_] * p[axis];
      curve.first = i;
      curve.second = j;
      curve.is_crossing = true;
      curves_.push_back(curve);
    }
}

// Different heights everywhere: by ranges, or by the mean value form of the difference of heights
// about the centre, in which parallel slopes cancel.
bool Reduction3D::proven_apart(int first, int second) const {
  if (ranges_[first].high < ranges_[second].low || ranges_[second].high < ranges_[first].low)
    return true;
  const LineSegment line{box_.center(), height_, box_.low[height_], box_.high[height_]};
  std::array<std::array<Interval, maximum_variables>, 2> gradients;
  Interval difference = 0.0;
  for (int k = 0; k < 2; ++k) {
    const int i = k == 0 ? first : second;
    const Crossing center = find_crossing(*active_->surfaces[i], line);
    // Where the graph does not exist, the way to it leaves its range of heights.
    gradients[k] = center.exists ? narrow_[i].gradient : bounds_[i].gradient;
    if (!gradients[k][height_].excludes_zero()) return false;
    const Interval height =
        Interval(center.position) -
        Interval(active_->surfaces[i]->value(line.at(center.position))) / gradients[k][height_];
    difference = k == 0 ? height : difference - height;
  }
  const auto &p = gradients[0], &q = gradients[1];
  for (int axis = 0; axis < 3; ++axis) {
    if (axis == height_) continue;
    const double radius = 0.5 * box_.length(axis);
    difference =
        difference + (q[axis] / q[height_] - p[axis] / p[height_]) * Interval(-radius, radius);
  }
  return difference.excludes_zero();
}

// Whether two graphs are one, up to rounding: they have no crossing curve, and a box bisected in
// search of one would never be accepted.
bool Reduction3D::coincide(int first, int second) const {
  // In general position: no curve of third degree passes through all of them, so that surfaces that
  // cross in straight lines or conics are told apart wherever these lie in the box.
  static constexpr std::array<std::array<double, 2>, 10> samples{{{0.03, 0.07},
                                                                  {0.31, -0.17},
                                                                  {-0.23, 0.41},
                                                                  {0.37, 0.29},
                                                                  {-0.39, -0.11},
                                                                  {-0.13, -0.43},
                                                                  {0.11, -0.37},
                                                                  {-0.43, 0.19},
                                                                  {0.19, 0.13},
                                                                  {-0.07, -0.29}}};
  const double same = 1e-13 * box_.length(height_);
  const int a = (height_ + 1) % 3, b = (height_ + 2) % 3;
  int both = 0;
  for (const auto& [u, v] : samples) {
    LineSegment line{box_.center(), height_, box_.low[height_], box_.high[height_]};
    line.through[a] += u * box_.length(a);
    line.through[b] += v * box_.length(b);
    const Crossing p = find_crossing(*active_->surfaces[first], line);
    const Crossing q = find_crossing(*active_->surfaces[second], line);
    if (!p.exists && !q.exists) continue;
    if (p.exists != q.exists || std::fabs(p.position - q.position) > same) return false;
    ++both;
  }
  return both >= 3;
}

// The inner axis over which all curves are graphs, or on which they do not depend; else,
// `in_any_case`, the one that is nearest to it.
bool Reduction3D::choose_inner(const Options& options, bool in_any_case) {
  const auto middle = [](const Interval& interval) {
    const double value = std::fabs(interval.middle());
    return std::isfinite(value) ? value : 0.0;
  };
  int proven = -1, likely = -1;
  double best = -1, nearest = -1;
  for (int axis = 0; axis < 3; ++axis) {
    if (axis == height_) continue;
    const int other = 3 - height_ - axis;
    bool serves = true;
    double score = 1, guess = 1;
    for (const Curve& curve : curves_) {
      const Interval &along = curve.gradient[axis], &across = curve.gradient[other];
      if (along.is_zero()) continue;
      const double change = middle(along) * box_.length(axis);
      const double total = change + middle(across) * box_.length(other) + 1e-300;
      guess = std::min(guess, change / total);
      if (options.allow_contacts && curve.is_crossing && !along.excludes_zero() &&
          !across.excludes_zero())
        continue;
      serves &= along.excludes_zero() && along.mignitude() >= options.flatness * across.magnitude();
      score = std::min(score, along.mignitude() * box_.length(axis) / total);
    }
    if (serves && score > best) {
      best = score;
      proven = axis;
    }
    if (guess > nearest) {
      nearest = guess;
      likely = axis;
    }
  }
  if (proven < 0 && !in_any_case) return false;
  inner_ = proven >= 0 ? proven : likely;
  return true;
}

}  // namespace rfm
