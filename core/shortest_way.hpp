#pragma once

#include <vector>

#include "core/necessary_signs.hpp"
#include "core/quadratic_program.hpp"
#include "core/second_derivatives.hpp"

namespace rfm {

/// What one of two regions is known to be within a box: points where some primitives have signs.
struct RegionPart {
  const RegionEvaluator* region;
  SecondDerivatives* second;
  Box box;
  std::vector<NecessarySign> signs;
};

/// The shortest way from a part of one region to a part of another: min |p − q|² under the
/// conditions gᵢ(p) ≥ 0, hⱼ(q) ≥ 0 that the signs are.
///
/// A local minimum is found by sequential quadratic programming, whose steps converge quadratically
/// where curvatures and the conditions that bind determine it. Its multipliers λ ≥ 0 give a proved
/// bound of all ways between the parts, since Lagrange's function
///
///     |p − q|² − Σ λᵢ gᵢ (1 − κᵢ gᵢ)
///
/// is nowhere above |p − q|² where the conditions hold and gᵢ ≤ 1/κᵢ, and has the same value and
/// no slope at the minimum. Where its second derivatives over the boxes are positive definite (κ
/// makes them so along the normals) the bound is the minimum itself, to rounding, however large the
/// boxes are: for convex bodies from the start. Along a curve of nearest points it is less by the
/// third power of the size of the boxes. Without κ (Hestenes 1969; Rockafellar 1973) there would be
/// a gap wherever a boundary curves away along its own normal more than |p − q|² makes up for.
/// Where it does make up, κ = 0 is better: of quadrics the function is then quadratic itself, and
/// along curves of nearest points, as between coaxial cylinders, as flat as the distance: the bound
/// is the minimum again. Both are tried.
class ShortestWay {
 public:
  /// At most `most_conditions` of each side are looked at: those that are nearest to the middle.
  static constexpr int most_conditions = 6;

  ShortestWay(const RegionPart& a, const RegionPart& b);

  /// The ends of the way, on the boundaries up to rounding; not necessarily within the boxes.
  const Point& end(int side) const { return ends_[side]; }
  /// Where to go from an end to get into its region, along the conditions that bind there.
  Point inwards(int side) const;
  /// A proved lower bound of |p − q| over the points of both parts in their boxes; 0 where nothing
  /// is known.
  double at_least() const;

 private:
  struct Condition {
    int side, primitive;
    double factor;  ///< of the primitive's function, so that its slope is near 1
    double multiplier = 0;
    double stiffness = 0;  ///< 2 λ κ
    double value = 0;      ///< at the end of its side
    Point slope{};
    Hessian<double> second{};
  };

  void add_conditions(int side);
  void evaluate();
  void stiffen();
  /// Makes one step; whether it was more than rounding.
  bool improve();
  double at_least(bool stiffened) const;
  bool add_to(QuadraticModel& model, const Condition& condition, const Point& about,
              bool stiffened) const;

  const RegionPart* parts_[2];
  int dimension_;
  double size_;  ///< of the boxes and of what is between them
  Point ends_[2];
  std::vector<Condition> conditions_;
};

}  // namespace rfm
