#pragma once

#include <optional>

#include "quadrature/ray_tree.hpp"

namespace rfm {

/// Where a ray enters a region.
struct RayHit {
  static constexpr int none = -1;
  /// Parameter of the point on the ray.
  double position = 0;
  Point point{};
  /// The primitive in whose surface the point lies; none where the ray starts inside.
  int primitive = none;
  /// ∇level/|∇level| of that primitive, turned to the side the ray comes from: the outward unit
  /// normal of the region. Opposite to the ray where the gradient vanishes (the apex of a cone).
  Point normal{};
};

struct RayCasterOptions {
  /// Halvings of the bounds at most: 32 parts along each side. More is slower to build than it
  /// saves for a picture of a million rays.
  int max_depth = 15;
};

/// Finds where rays enter a region, by what is proven of its primitives along them:
///
/// - parts of space where the region is known by bounds are skipped (`RayTree`);
/// - in other parts the zeros of each primitive along the ray are isolated: of quadrics in closed
///   form, of other functions by bounds of value and slope along the ray (Taylor models in its
///   parameter), bisected until each bracket holds one zero or none, then Newton's method;
/// - between zeros the signs of the primitives are constant, and the Boolean expression says
/// whether
///   the ray is inside.
///
/// Nothing is sampled: walls may be as thin as rounding allows, about 10⁻¹² of the size, edges are
/// sharp, and positions are exact to about 10⁻¹⁴ of the size where the ray is not tangential. Zeros
/// that cannot be told apart within 6·10⁻⁸ of a part, where a ray touches a surface that is no
/// quadric, count as one.
class RayCaster {
 public:
  /// `bounds` must hold the region, or what is to be seen of it; 2 or 3 dimensions. Keeps a
  /// reference to `region`.
  RayCaster(const RegionEvaluator& region, const Box& bounds, const RayCasterOptions& options = {});

  /// The first point of the region on a ray at a parameter ≥ 0; a ray that starts inside hits at 0.
  /// Thread-safe.
  std::optional<RayHit> first_entry(const Line& ray) const;

  const RayTree& tree() const { return tree_; }

 private:
  RayHit hit_at(const Line& ray, double position, int primitive) const;
  int nearest_primitive(const Line& ray, double position) const;

  const RegionEvaluator& region_;
  RayTree tree_;
  /// Zeros nearer than this are one event.
  double same_place_;
};

}  // namespace rfm
