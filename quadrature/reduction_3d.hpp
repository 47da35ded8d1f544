#pragma once

#include <optional>

#include "quadrature/reduction_2d.hpp"

namespace rfm {

/// A box of space in which every surface is, in the height direction, a graph over the other two
/// axes or independent of the height. Sections across the outer axis are reduced as planes, with
/// the inner axis as base; between neighbouring breakpoints of the outer axis the order of the
/// breakpoints of the sections does not change.
///
/// Breakpoints of sections move along curves of the (outer, inner) plane: traces of the surfaces on
/// bottom and top, surfaces independent of the height, and crossings of two graphs. The inner axis
/// is chosen so that these curves are graphs over the outer axis. Breakpoints of the outer axis are
/// where a curve enters or ends and where two curves meet; all of them are isolated with bounds of
/// the slopes, so that no pair of events within one interval is missed.
///
/// Surfaces that only touch have no crossing curve that could be proved a graph. Where they touch
/// their order does not change and nothing has to be split: with `allow_contacts` such a pair is
/// accepted on the evidence of its critical points (see `only_touch`) and counted in
/// `has_contacts`. So is a surface that touches bottom or top from one side: it has no trace there.
/// Of quadrics the range on that side proves it; with `allow_contacts` others are accepted, too.
class Reduction3D {
 public:
  struct Options {
    /// Curves may be as steep as 1 / flatness.
    double flatness = 0;
    /// Surfaces that only touch each other or a side may be accepted by evidence.
    bool allow_contacts = false;
    /// Reduce in any case, uncertified.
    bool best_effort = false;
    /// A best effort without a search for places where curves meet: the budget is spent.
    bool in_haste = false;
  };
  enum class Outcome {
    reduced,
    /// No inner axis serves: the box has to be bisected across an axis other than the height.
    not_reduced,
    /// A surface has one sign on bottom and top, hence everywhere: see `constant_surface`.
    constant_surface
  };

  /// `bounds[i]` encloses surface i over the box.
  Outcome build(const Box& box, const ActiveSet& active, std::span<const FunctionBounds> bounds,
                int height, const Options& options);

  int constant_surface() const { return constant_surface_; }
  bool constant_sign() const { return constant_sign_; }

  const Box& box() const { return box_; }
  const ActiveSet& active() const { return *active_; }
  int outer() const { return 3 - height_ - inner_; }
  int inner() const { return inner_; }
  int height() const { return height_; }
  const std::vector<double>& breakpoints() const { return breakpoints_; }
  /// Those at which surfaces touch: sections there, and only there, take them for one.
  const std::vector<double>& contacts() const { return contacts_; }
  /// Where surfaces stand that depend on the outer coordinate alone.
  const std::vector<Wall>& walls() const { return walls_; }
  /// Surfaces that depend on the outer coordinate alone.
  SurfaceSigns outer_only() const { return outer_only_; }
  /// False if a root was not isolated, or if lines met something so thin that surfaces were taken
  /// for one: the rule is then a best effort.
  bool certified() const { return certified_ && section_.certified(); }
  /// Some surfaces touch in the box as far as samples tell.
  bool has_contacts() const { return has_contacts_; }
  double negligible_width() const { return 1e-14 * box_.length(outer()); }

  /// The section at an outer coordinate; the reference is valid until the next call.
  const Reduction2D& section(double outer_coordinate);

 private:
  /// A curve of the (outer, inner) plane.
  struct Curve {
    std::array<Interval, maximum_variables> gradient;
    /// Bounds of the slope of the inner coordinate over the outer one.
    Interval slope;
    int first = 0;
    /// The other surface of a crossing, or the end (bottom, top) of a trace.
    int second = 0;
    bool is_crossing = false;
    bool is_vertical = false;
    Meeting meeting = Meeting::unknown;
  };

  bool is_vertical(int surface) const { return bounds_[surface].gradient[height_].is_zero(); }
  bool find_axes(const Options& options);
  bool find_traces(bool tight, const Options& options);
  Truth add_trace(int surface, int end, bool tight, bool by_evidence);
  Truth touching_sign(int surface, const Box& face, bool by_evidence);
  void narrow_graphs();
  void add_crossing_curves();
  bool proven_apart(int first, int second) const;
  bool coincide(int first, int second) const;
  bool choose_inner(const Options& options, bool in_any_case);
  bool accept_contacts();
  bool only_touch(const Curve& crossing);
  void set_proofs(bool in_haste);
  void find_breakpoints(bool in_haste);
  void add_face_breakpoints(double inner_coordinate, bool in_haste);
  void add_meetings(bool of_crossings);
  void add_meetings(std::size_t first, std::size_t second);
  void add_found_meetings();
  void add_contact(double low, double high);
  bool are_apart(const Curve& a, const Curve& b) const;
  bool may_meet(const Curve& a, const Curve& b) const;

  /// Where a curve is in a section: its inner coordinate, or the end of the section nearest to it.
  struct CurvePoint {
    double position = 0;
    bool exists = false;
    /// Of the position over the outer coordinate.
    double slope = 0;
    /// Its height in space.
    double height = 0;
  };
  CurvePoint curve_point(const Curve& curve, double outer_coordinate) const;
  const CurvePoint& middle_point(std::size_t curve, std::size_t interval);
  CurvePoint trace_point(const Curve& trace, double outer_coordinate) const;
  CurvePoint crossing_point(const Curve& crossing, double outer_coordinate) const;
  Interval existence(int surface, double outer_coordinate) const;
  Interval slope_bounds(const Curve& curve, double from, double to) const;
  Plane section_plane(double outer_coordinate) const;
  SurfaceSigns outer_signs(double place) const;
  Plane base_plane() const { return {box_, outer(), inner_}; }
  PlaneGraph section_graph(int surface, double outer_coordinate) const {
    return {active_->surfaces[surface], &bounds_[surface], outer_coordinate};
  }
  PlaneGraph base_graph(const Curve& curve) const;

  Box box_;
  const ActiveSet* active_ = nullptr;
  std::span<const FunctionBounds> bounds_;
  int height_ = 2, inner_ = 1;
  int constant_surface_ = -1;
  bool constant_sign_ = false;
  std::vector<Curve> curves_;
  std::array<std::array<FunctionBounds, 2>, ActiveSet::capacity> traces_;
  /// Signs of the graphs on bottom and top, where they have no trace.
  std::array<std::array<Truth, 2>, ActiveSet::capacity> end_signs_;
  /// Of each graph: the heights it takes in the box, and bounds over these heights alone.
  std::array<Interval, ActiveSet::capacity> ranges_;
  std::array<FunctionBounds, ActiveSet::capacity> narrow_;
  PlaneProofs proofs_;
  std::vector<double> breakpoints_, contacts_, standing_, found_;
  std::vector<std::optional<CurvePoint>> middles_;
  std::vector<Wall> walls_;
  SurfaceSigns outer_only_ = 0;
  std::array<EndSigns, 2> touching_{};
  bool certified_ = true;
  bool has_contacts_ = false;
  Reduction2D section_;
};

}  // namespace rfm
