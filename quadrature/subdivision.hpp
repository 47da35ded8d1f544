#pragma once

#include <deque>
#include <vector>

#include "quadrature/height_direction.hpp"
#include "quadrature/reduction_3d.hpp"
#include "quadrature/subdivision_options.hpp"

namespace rfm {

/// How the parts that follow are known.
struct PartQuality {
  static constexpr int unlimited = 1000;
  /// Gauss points that a piece may have: few when the budget is spent.
  int most_points = unlimited;
  /// Bounds prove the structure.
  bool proven = true;
};

/// Receives the parts into which a cell is taken apart. They do not overlap; what is not reported
/// is outside.
class PartVisitor {
 public:
  virtual ~PartVisitor() = default;
  /// A box inside the region.
  virtual void full(const Box& box, const Frame* frame) = 0;
  /// An interval on whose points surfaces are monotone.
  virtual void reduced(const ActiveSet& active, const LineSegment& line) = 0;
  virtual void reduced(const Reduction2D& reduction) = 0;
  /// Not const: sections share the memory of the reduction.
  virtual void reduced(Reduction3D& reduction) = 0;
  /// Comes before `reduced` in the plane and in space.
  virtual void begin(const PartQuality&) {}
  /// The part reported last is a best effort, in which `missing` of the boundary may be missing.
  virtual void not_certified(double /* missing */) {}
};

/// Takes boxes apart: bounds fix the signs of surfaces, and a box with a height direction is
/// reduced; another is bisected (or, near a corner of the plane, seen in a rotated frame; or
/// surfaces that are planes across an axis up to rounding are replaced by these). Where nothing
/// serves, interfaces are left out before pieces of the boundary are lost.
class Subdivision {
 public:
  explicit Subdivision(const SubdivisionOptions& options) : options_(options) {}

  /// Reports the parts of `box` to `visitor`; returns what was not certified. `share` is the part
  /// of the budget for this box.
  Uncertified run(const Box& box, const ActiveSet& active, PartVisitor& visitor, double share = 1);

 private:
  struct Waiting {
    Box box;
    ActiveSet active;
    int depth;
  };

  void visit_waiting();
  void visit(const Box& box, ActiveSet active, int depth);
  void bisect_later(const Box& box, const ActiveSet& active, int depth, int axis);
  bool flattened(const Box& box, const ActiveSet& active, std::span<const FunctionBounds> bounds,
                 int depth);
  bool without_interfaces(const Box& box, const ActiveSet& active, int depth);
  bool rotated(const Box& box, const ActiveSet& active, int depth);
  bool reduced(const Box& box, const ActiveSet& active, std::span<const FunctionBounds> bounds,
               const HeightDirections& heights, int depth);
  bool space_reduced(const Box& box, const ActiveSet& active,
                     std::span<const FunctionBounds> bounds, const HeightDirections& heights,
                     int depth);
  bool may_bisect(const ActiveSet& active, int depth) const;
  template <class Reduction>
  void report(Reduction& reduction, bool proven);
  void add_contact(const Box& box);
  /// After `box` was reported; `missing`: of the boundary.
  void add_uncertified(const Box& box, double missing);
  double flatness(int dimension, int depth) const;

  SubdivisionOptions options_;
  PartVisitor* visitor_ = nullptr;
  const Frame* frame_ = nullptr;
  int max_depth_ = 0;
  /// The part reported last had fewer points.
  bool is_limited_ = false;
  std::vector<Waiting> waiting_;
  /// Of the boxes of this run; not moved when there are more.
  std::deque<Surface> planes_;
  std::size_t next_ = 0;
  Uncertified uncertified_;
  Reduction2D plane_;
  Reduction3D space_;
};

}  // namespace rfm
