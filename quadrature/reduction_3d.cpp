#include "quadrature/reduction_3d.hpp"

#include <algorithm>
#include <cmath>

namespace rfm {

Reduction3D::Outcome Reduction3D::build(const Box& box, const ActiveSet& active,
                                        std::span<const FunctionBounds> bounds, int height,
                                        const Options& options) {
  box_ = box;
  active_ = &active;
  bounds_ = bounds;
  height_ = height;
  certified_ = true;
  has_contacts_ = false;
  proofs_.higher = {};
  constant_surface_ = -1;
  if (!find_axes(options))
    return constant_surface_ >= 0 ? Outcome::constant_surface : Outcome::not_reduced;
  set_proofs(options.in_haste);
  if (!options.in_haste && !accept_contacts() && !options.best_effort) return Outcome::not_reduced;
  find_breakpoints(options.in_haste);
  find_walls(
      standing_, box.low[outer()], box.high[outer()],
      [&](double place) { return outer_signs(place); }, walls_);
  return Outcome::reduced;
}

// The curves of the base plane, and the inner axis over which they are graphs. Bounds over the
// whole box often serve for traces too, and are known already; tight ones are found where these do
// not do. Traces alone often tell that neither axis serves; crossings come after them.
bool Reduction3D::find_axes(const Options& options) {
  for (const bool tight : {false, true}) {
    const bool all_change_sign = find_traces(tight, options);
    if (!all_change_sign && !options.best_effort) return false;
    const bool in_any_case = options.best_effort && tight;
    if (!choose_inner(options, in_any_case)) continue;
    if (!all_change_sign || active_->count == 1) return true;
    narrow_graphs();
    add_crossing_curves();
    if (choose_inner(options, in_any_case)) return true;
  }
  return false;
}

void Reduction3D::set_proofs(bool in_haste) {
  for (auto& ends : proofs_.ends) ends.fill(Meeting::never);
  for (auto& row : proofs_.crossings) row.fill(Meeting::never);
  proofs_.touching = touching_;
  outer_only_ = 0;
  for (Curve& curve : curves_) {
    const Interval& along = curve.gradient[inner_];
    // What does not depend on the inner coordinate is constant in a section. In haste crossings
    // serve to choose axes alone: to find them would take most of the time.
    curve.meeting = along.is_zero() || (curve.is_crossing && in_haste) ? Meeting::never
                    : curve.is_crossing && !along.excludes_zero()      ? Meeting::unknown
                                                                       : Meeting::at_most_once;
    curve.slope = -(curve.gradient[outer()] / along);
    if (curve.is_crossing)
      proofs_.crossings[curve.first][curve.second] = curve.meeting;
    else
      proofs_.ends[curve.first][curve.second] = curve.meeting;
    if (curve.is_vertical && along.is_zero()) outer_only_ |= 1u << curve.first;
  }
}

const Reduction2D& Reduction3D::section(double outer_coordinate) {
  Box box = box_;
  box.low[outer()] = box.high[outer()] = outer_coordinate;
  certified_ &= section_.certified();
  section_.build({box, inner_, height_}, *active_, bounds_, proofs_);
  return section_;
}

PlaneGraph Reduction3D::base_graph(const Curve& curve) const {
  const int i = curve.first;
  if (curve.is_vertical)
    return {active_->surfaces[i], &bounds_[i], 0.5 * (box_.low[height_] + box_.high[height_])};
  return {active_->surfaces[i], &traces_[i][curve.second],
          curve.second == 0 ? box_.low[height_] : box_.high[height_]};
}

void Reduction3D::find_breakpoints(bool in_haste) {
  breakpoints_.assign({box_.low[outer()], box_.high[outer()]});
  contacts_.clear();
  standing_.clear();
  found_.clear();
  // Surfaces that depend on the outer coordinate alone.
  for (const Curve& curve : curves_)
    if (outer_only_ >> curve.first & 1 && curve.is_vertical)
      certified_ &=
          isolate_level(base_plane(), base_graph(curve), box_.center()[inner_], standing_);
  breakpoints_.insert(breakpoints_.end(), standing_.begin(), standing_.end());
  add_face_breakpoints(box_.low[inner_], in_haste);
  add_face_breakpoints(box_.high[inner_], in_haste);
  std::ranges::sort(breakpoints_);
  if (in_haste) return;
  // A crossing ends where traces of its surfaces meet: these come first.
  add_meetings(false);
  add_meetings(true);
}

// Where curves enter or leave through the faces of the inner axis: the breakpoints of these faces.
void Reduction3D::add_face_breakpoints(double inner_coordinate, bool in_haste) {
  const Meeting meeting = in_haste ? Meeting::at_most_once : Meeting::unknown;
  PlaneProofs proofs;
  for (auto& ends : proofs.ends) ends.fill(Meeting::never);
  for (auto& row : proofs.crossings) row.fill(Meeting::never);
  for (const Curve& curve : curves_) {
    if (curve.is_crossing)
      proofs.crossings[curve.first][curve.second] = in_haste ? Meeting::never : meeting;
    else if (!(curve.is_vertical && outer_only_ >> curve.first & 1))
      proofs.ends[curve.first][curve.second] = meeting;
  }
  Box face = box_;
  face.low[inner_] = face.high[inner_] = inner_coordinate;
  certified_ &= section_.certified();
  section_.build({face, outer(), height_}, *active_, bounds_, proofs);
  for (const auto& [position, cause] : section_.breakpoints()) {
    if (cause == Reduction2D::Breakpoint::side_of_box) continue;
    if (cause == Reduction2D::Breakpoint::contact) {
      // Found on both faces, each to the root of the rounding: one is enough.
      const double same = 1e-5 * box_.length(outer());
      if (std::ranges::any_of(contacts_, [&, place = position](double other) {
            return std::fabs(other - place) <= same;
          }))
        continue;
      contacts_.push_back(position);
    }
    breakpoints_.push_back(position);
  }
}

SurfaceSigns Reduction3D::outer_signs(double place) const {
  Point point = box_.center();
  point[outer()] = place;
  SurfaceSigns signs = 0;
  for (int i = 0; i < active_->count; ++i)
    if (outer_only_ >> i & 1 && active_->surfaces[i]->value(point) >= 0) signs |= 1u << i;
  return signs;
}

}  // namespace rfm
