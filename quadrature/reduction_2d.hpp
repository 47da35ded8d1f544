#pragma once

#include <span>
#include <vector>

#include "quadrature/plane_graphs.hpp"
#include "quadrature/walls.hpp"

namespace rfm {

/// How often a curve can meet a line: what is proved beforehand saves isolation.
enum class Meeting : signed char { never, at_most_once, unknown };

/// What is known of the breakpoints of a plane before they are sought.
struct PlaneProofs {
  /// Surface i with the bottom and the top; a vertical surface uses the first entry.
  std::array<std::array<Meeting, 2>, ActiveSet::capacity> ends;
  /// Graphs i < j with each other.
  std::array<std::array<Meeting, ActiveSet::capacity>, ActiveSet::capacity> crossings;
  /// Surfaces that touch the bottom or the top without passing through it.
  std::array<EndSigns, 2> touching{};
  /// Bit j of entry i: graph i is known to be higher than graph j wherever they do not touch.
  std::array<SurfaceSigns, ActiveSet::capacity> higher{};

  PlaneProofs() {
    for (auto& end : ends) end.fill(Meeting::unknown);
    for (auto& row : crossings) row.fill(Meeting::unknown);
  }
};

/// A rectangle in which every surface is, in the height direction, a graph over the base axis or
/// independent of the height ("vertical"). Between neighbouring breakpoints of the base axis the
/// order of the surfaces along lines of the height direction does not change, so that an integral
/// over the region is an iterated integral of smooth functions:
///
///     ∫∫ f = Σ over [p, q] of breakpoints ∫_p^q Σ over inside parts of the line ∫ f dη dξ.
///
/// Breakpoints are where a graph meets the bottom or the top of the box, where a vertical surface
/// stands, and where two graphs cross; places where they only touch are among them, although the
/// order stays the same. The rectangle is a box of the plane or a section of a box of
/// space. Method: R. I. Saye, SIAM J. Sci. Comput. 37 (2015), carried from one implicit function to
/// Boolean combinations.
class Reduction2D : private LineNeighbours {
 public:
  /// A breakpoint and what causes it: a number that is the same for the same cause in parallel
  /// sections.
  struct Breakpoint {
    static constexpr int side_of_box = -1, contact = -2;
    double position = 0;
    int cause = side_of_box;
  };

  static constexpr int end_cause(int surface, int end) { return 2 * surface + end; }
  static constexpr int crossing_cause(int first, int second) {
    return 2 * ActiveSet::capacity * (first + 1) + second;
  }

  /// `bounds[i]` encloses surface i over the rectangle. Memory of earlier ones is reused.
  void build(const Plane& plane, const ActiveSet& active, std::span<const FunctionBounds> bounds,
             const PlaneProofs& proofs, const Frame* frame = nullptr);

  const ActiveSet& active() const { return *active_; }
  /// The frame in which box and surfaces are given; null for the world.
  const Frame* frame() const { return frame_; }
  const Plane& plane() const { return plane_; }
  int base() const { return plane_.base; }
  int height() const { return plane_.height; }
  /// Surfaces that do not depend on the height.
  SurfaceSigns vertical() const { return vertical_; }
  /// Ascending, the sides of the box included.
  const std::vector<Breakpoint>& breakpoints() const { return breakpoints_; }
  /// Where vertical surfaces stand.
  const std::vector<Wall>& walls() const { return walls_; }
  /// False if a root was not isolated, or if lines met something so thin that surfaces were taken
  /// for one: the rule is then a best effort.
  bool certified() const { return certified_; }

  /// The segment of the height direction at a place of the base axis.
  LineSegment line(double place) const {
    LineSegment segment = height_line(plane_, graph(0), place);
    segment.ends = touching_;
    segment.neighbours = this;
    return segment;
  }
  /// Intervals of the base axis shorter than this are empty up to rounding.
  double negligible_width() const { return 1e-14 * plane_.base_length(); }

 private:
  bool is_vertical(int surface) const { return vertical_ >> surface & 1; }
  PlaneGraph graph(int surface) const {
    return {active_->surfaces[surface], &bounds_[surface], plane_.box.low[plane_.third()]};
  }
  void add_ends(int surface, const PlaneProofs& proofs);
  void add_crossings(int first, int second, bool at_most_once);
  void add_found(std::vector<double>& found, int cause);
  Interval common_range(int first, int second, double place) const;
  double height_over(int first, int second, double place) const;
  double height_over(int first, int second, const LineSegment& line) const override;
  void note_loss() const override { certified_ = false; }
  SurfaceSigns vertical_signs(double place) const;

  Plane plane_;
  const ActiveSet* active_ = nullptr;
  const Frame* frame_ = nullptr;
  std::span<const FunctionBounds> bounds_;
  SurfaceSigns vertical_ = 0;
  std::array<EndSigns, 2> touching_{};
  std::array<SurfaceSigns, ActiveSet::capacity> higher_{};
  std::vector<Breakpoint> breakpoints_;
  std::vector<double> standing_, found_, contacts_;
  std::vector<Wall> walls_;
  mutable bool certified_ = true;
  /// What was asked for: pairs of graphs, and the interval on which the answer is the same.
  struct KnownHeight {
    int first, second;
    Interval range;
    double height;
  };
  mutable std::vector<KnownHeight> known_heights_;
};

}  // namespace rfm
