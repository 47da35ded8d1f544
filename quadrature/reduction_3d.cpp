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
  certified_ = contacts_resolved_ = true;
  if (!find_curves() && !options.best_effort) return Outcome::constant_surface;
  if (!choose_inner(options)) return Outcome::not_reduced;
  set_proofs();
  find_breakpoints();
  if (!contacts_resolved_ && !options.best_effort) return Outcome::not_reduced;
  find_walls(
      standing_, box.low[outer()], box.high[outer()],
      [&](double place) { return outer_signs(place); }, walls_);
  return Outcome::reduced;
}

void Reduction3D::set_proofs() {
  for (auto& ends : proofs_.ends) ends.fill(Meeting::never);
  for (auto& row : proofs_.crossings) row.fill(Meeting::never);
  outer_only_ = 0;
  for (Curve& curve : curves_) {
    const Interval& along = curve.gradient[inner_];
    // What does not depend on the inner coordinate is constant in a section. A best effort takes
    // what it can get from signs.
    curve.meeting = along.is_zero()                               ? Meeting::never
                    : curve.is_crossing && !along.excludes_zero() ? Meeting::unknown
                                                                  : Meeting::at_most_once;
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
  section_.build({box, inner_, height_}, *active_, bounds_, proofs_);
  certified_ &= section_.certified();
  return section_;
}

PlaneGraph Reduction3D::base_graph(const Curve& curve) const {
  const int i = curve.first;
  if (curve.is_vertical)
    return {active_->surfaces[i], &bounds_[i], 0.5 * (box_.low[height_] + box_.high[height_])};
  return {active_->surfaces[i], &traces_[i][curve.second],
          curve.second == 0 ? box_.low[height_] : box_.high[height_]};
}

void Reduction3D::find_breakpoints() {
  breakpoints_.assign({box_.low[outer()], box_.high[outer()]});
  standing_.clear();
  found_.clear();
  // Surfaces that depend on the outer coordinate alone.
  for (const Curve& curve : curves_)
    if (outer_only_ >> curve.first & 1 && curve.is_vertical)
      certified_ &=
          isolate_level(base_plane(), base_graph(curve), box_.center()[inner_], standing_);
  breakpoints_.insert(breakpoints_.end(), standing_.begin(), standing_.end());
  add_face_breakpoints(box_.low[inner_]);
  add_face_breakpoints(box_.high[inner_]);
  std::ranges::sort(breakpoints_);
  add_crossings_of_traces();
  add_changes_of_order();
}

// Where curves enter or leave through the faces of the inner axis: the breakpoints of these faces.
void Reduction3D::add_face_breakpoints(double inner_coordinate) {
  PlaneProofs proofs;
  for (auto& ends : proofs.ends) ends.fill(Meeting::never);
  for (auto& row : proofs.crossings) row.fill(Meeting::never);
  for (const Curve& curve : curves_) {
    if (curve.is_crossing)
      proofs.crossings[curve.first][curve.second] = Meeting::unknown;
    else if (!(curve.is_vertical && outer_only_ >> curve.first & 1))
      proofs.ends[curve.first][curve.second] = Meeting::unknown;
  }
  Box face = box_;
  face.low[inner_] = face.high[inner_] = inner_coordinate;
  section_.build({face, outer(), height_}, *active_, bounds_, proofs);
  certified_ &= section_.certified();
  for (const auto& breakpoint : section_.breakpoints())
    if (breakpoint.cause != Reduction2D::Breakpoint::side_of_box)
      breakpoints_.push_back(breakpoint.position);
}

// Where two of the traces and vertical surfaces cross. A bottom trace may cross a top trace: then
// nothing meets in space, but the inner integral has a kink.
void Reduction3D::add_crossings_of_traces() {
  const Plane plane = base_plane();
  const auto is_graph = [&](const Curve& curve) {
    return !curve.is_crossing && curve.meeting == Meeting::at_most_once;
  };
  for (std::size_t a = 0; a < curves_.size(); ++a)
    for (std::size_t b = a + 1; b < curves_.size(); ++b) {
      if (!is_graph(curves_[a]) || !is_graph(curves_[b]) || curves_[a].first == curves_[b].first)
        continue;
      const PlaneGraph p = base_graph(curves_[a]), q = base_graph(curves_[b]);
      if (rfm::proven_apart(plane, p, q)) continue;
      const auto exist = [&](double place) {
        return find_crossing(*p.surface, height_line(plane, p, place)).exists &&
               find_crossing(*q.surface, height_line(plane, q, place)).exists;
      };
      for (std::size_t k = 0; k + 1 < breakpoints_.size(); ++k) {
        const double from = breakpoints_[k], to = breakpoints_[k + 1];
        if (to - from <= negligible_width() || !exist(0.5 * (from + to))) continue;
        certified_ &= isolate_crossings(plane, p, q, from, to, found_);
      }
      if (found_.empty()) continue;
      breakpoints_.insert(breakpoints_.end(), found_.begin(), found_.end());
      found_.clear();
      std::ranges::sort(breakpoints_);
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
