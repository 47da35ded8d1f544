#pragma once

#include "quadrature/reduction_2d.hpp"

namespace rfm {

/// A box of space in which every surface is, in the height direction, a graph over the other two
/// axes or independent of the height. Sections across the outer axis are reduced as planes, with
/// the inner axis as base; between neighbouring breakpoints of the outer axis the order of the
/// breakpoints of the sections does not change.
///
/// Breakpoints of sections move along curves of the (outer, inner) plane: traces of the surfaces on
/// bottom and top, surfaces independent of the height, and crossings of two graphs. The inner axis
/// is chosen so that these curves are graphs over the outer axis; a crossing curve along which two
/// surfaces only touch is no graph that could be proved, and may be left to isolation in every
/// section.
class Reduction3D {
 public:
  struct Options {
    /// Curves may be as steep as 1 / flatness.
    double flatness = 0;
    /// Crossing curves that no axis proves are isolated in every section.
    bool allow_contacts = false;
    /// Reduce in any case, uncertified.
    bool best_effort = false;
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
  /// Where surfaces stand that depend on the outer coordinate alone.
  const std::vector<Wall>& walls() const { return walls_; }
  /// Surfaces that depend on the outer coordinate alone.
  SurfaceSigns outer_only() const { return outer_only_; }
  bool certified() const { return certified_; }
  double negligible_width() const { return 1e-14 * box_.length(outer()); }

  /// The section at an outer coordinate; the reference is valid until the next call.
  const Reduction2D& section(double outer_coordinate);

 private:
  /// A curve of the (outer, inner) plane.
  struct Curve {
    std::array<Interval, 3> gradient;
    int first = 0;
    /// The other surface of a crossing, or the end (bottom, top) of a trace.
    int second = 0;
    bool is_crossing = false;
    bool is_vertical = false;
    Meeting meeting = Meeting::unknown;
  };

  bool is_vertical(int surface) const { return bounds_[surface].gradient[height_].is_zero(); }
  bool find_curves();
  void narrow_graphs();
  void add_crossing_curves();
  bool proven_apart(int first, int second) const;
  bool coincide(int first, int second) const;
  bool choose_inner(const Options& options);
  void set_proofs();
  void find_breakpoints();
  void add_face_breakpoints(double inner_coordinate);
  void add_crossings_of_traces();
  void add_changes_of_order();
  bool changes_sign(const Curve& crossing) const;
  SurfaceSigns outer_signs(double place) const;
  Plane base_plane() const { return {box_, outer(), inner_}; }
  PlaneGraph base_graph(const Curve& curve) const;

  Box box_;
  const ActiveSet* active_ = nullptr;
  std::span<const FunctionBounds> bounds_;
  int height_ = 2, inner_ = 1;
  int constant_surface_ = -1;
  bool constant_sign_ = false;
  std::vector<Curve> curves_;
  std::array<std::array<FunctionBounds, 2>, ActiveSet::capacity> traces_;
  /// Of each graph: the heights it takes in the box, and bounds over these heights alone.
  std::array<Interval, ActiveSet::capacity> ranges_;
  std::array<FunctionBounds, ActiveSet::capacity> narrow_;
  PlaneProofs proofs_;
  std::vector<double> breakpoints_, standing_, found_;
  std::vector<Wall> walls_;
  SurfaceSigns outer_only_ = 0;
  bool certified_ = true;
  /// Every crossing curve left to isolation is a contact, or meets every section once.
  bool contacts_resolved_ = true;
  Reduction2D section_;
};

}  // namespace rfm
