#pragma once

#include <span>
#include <vector>

#include "quadrature/line_roots.hpp"

namespace rfm {

/// A box of the plane in which every surface is, in the height direction, a graph over the base
/// axis or independent of the height ("vertical"). Between neighbouring breakpoints of the base
/// axis the order of the surfaces along lines of the height direction does not change, so that an
/// integral over the region is an iterated integral of smooth functions:
///
///     ∫∫ f = Σ over [p, q] of breakpoints ∫_p^q Σ over inside parts of the line ∫ f dη dξ.
///
/// Breakpoints are where a graph meets the bottom or the top of the box, where a vertical surface
/// stands, and where two graphs cross. Method: R. I. Saye, SIAM J. Sci. Comput. 37 (2015), carried
/// from one implicit function to Boolean combinations.
class Reduction2D {
 public:
  /// A vertical surface at `position`: the signs of the vertical surfaces on both sides of it.
  struct Wall {
    double position = 0;
    SurfaceSigns left = 0;
    SurfaceSigns right = 0;
  };

  /// `bounds[i]` encloses surface i over the box. Memory of earlier boxes is reused.
  void build(const Box& box, const ActiveSet& active, std::span<const FunctionBounds> bounds,
             int height, const Frame* frame);

  const Box& box() const { return box_; }
  const ActiveSet& active() const { return *active_; }
  /// The frame in which box and surfaces are given; null for the world.
  const Frame* frame() const { return frame_; }
  int base() const { return 1 - height_; }
  int height() const { return height_; }
  /// Surfaces that do not depend on the height.
  SurfaceSigns vertical() const { return vertical_; }
  /// Ascending, the sides of the box included.
  const std::vector<double>& breakpoints() const { return breakpoints_; }
  const std::vector<Wall>& walls() const { return walls_; }
  /// False if a root was not isolated: the rule is then a best effort.
  bool certified() const { return certified_; }

  /// The segment of the height direction at a place of the base axis.
  LineSegment line(double place) const;
  /// Intervals of the base axis shorter than this are empty up to rounding.
  double negligible_width() const { return 1e-14 * box_.length(base()); }

 private:
  bool is_vertical(int surface) const { return vertical_ >> surface & 1; }
  void add_ends_of_graphs(int surface);
  void add_crossings(int first, int second);
  bool proven_apart(int first, int second) const;
  void find_walls();
  SurfaceSigns vertical_signs(double place) const;
  void sort_breakpoints();

  Box box_;
  const ActiveSet* active_ = nullptr;
  const Frame* frame_ = nullptr;
  std::span<const FunctionBounds> bounds_;
  int height_ = 1;
  SurfaceSigns vertical_ = 0;
  std::vector<double> breakpoints_, standing_, found_;
  std::vector<Wall> walls_;
  bool certified_ = true;
};

}  // namespace rfm
