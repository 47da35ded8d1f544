#pragma once

#include <optional>
#include <vector>

#include "core/field.hpp"

namespace rfm {

/// How a trim function that is a conjunction is smoothed away from the surface γ = 0 on which it is
/// needed: s = a γᵏ in the conditional R-function x + y − √(x² + y² + s) (Shapiro 2007, §5.2).
struct ConditionalOptions {
  double a = 1;  ///< positive; in lengths of the set
  int k = 2;     ///< even, 2 to 16: the larger, the nearer it is to R₀ next to the surface
};

/// The conjunction of trim functions, from left to right: R₀ on γ = 0, analytic everywhere but
/// where two of them vanish on γ = 0. Throws `InvalidArgument` for none, unless a > 0, and unless k
/// is even, from 2 to 16.
Field trimming_conjunction(const std::vector<Field>& fields, const Field& gamma,
                           const ConditionalOptions& options = {});

/// A closed set without interior: points, curves, surfaces that need not bound anything (Shapiro
/// 2007, §5.2). `function` is zero exactly on it and positive elsewhere, normalised at its regular
/// points (all but its ends), at least twice differentiable off the set.
struct ThinSet {
  int dimension = 2;  ///< of the space
  Field function;
  /// γ where the set is {γ = 0} ∩ {where ≥ 0}: of curves in the plane and of surfaces.
  std::optional<Field> surface;
  Field where = 1.0;
  /// Smooth functions, one of which is zero wherever the set ends within γ = 0.
  std::vector<Field> ends;
  /// The ends of a segment or an arc, the corners of a triangle, the place of a point.
  std::vector<Point> points;
  /// Of an arc: the tangent of a quarter of its angle, from the first to the second point.
  double bulge = 0;
  /// Of a chain of segments or a surface of triangles: these. All above but `function` is theirs.
  std::vector<ThinSet> parts = {};
};

/// |x − p|. Its derivatives do not exist at p.
ThinSet point_set(const Point& point, int dimension = 2);
/// In the plane the line trimmed (eq. 5.1) by λ = (L²/4 − |x − m|²)/L, m the midpoint: normalised
/// across the line, and at the ends λ has slope 1. In space the same with the distance from the
/// line for γ, through its square. Throws `InvalidArgument` if the ends coincide.
ThinSet segment_set(const Point& from, const Point& to, int dimension = 2);
/// The arc from angle `from` counter-clockwise to `to` (radians, in the plane), at most a full
/// circle: (r² − |x − c|²)/2r trimmed by the half-plane of its chord. Throws `InvalidArgument`
/// unless radius > 0 and 0 < to − from ≤ 2π (up to rounding).
ThinSet arc_set(const Point& center, double radius, double from, double to);
/// The part of {of = 0} where `where` ≥ 0 (all without it); `of` is normalised by eq. (4.9). A
/// curve in the plane, a surface in space.
ThinSet level_curve_set(const Field& of, const std::optional<Field>& where, int dimension = 2);
/// A triangle in space: its plane trimmed by the prism over its edges, joined by conditional
/// R-conjunction, so that the function is analytic off the triangle (figure 5.5 of Shapiro 2007).
/// Throws `InvalidArgument` if the corners lie on a line.
ThinSet triangle_set(const Point& a, const Point& b, const Point& c,
                     const ConditionalOptions& options = {});

/// The union by R-equivalence ~p, in closed form [Σ ωᵢ⁻ᵖ]^(−1/p) (0 where one of them is),
/// evaluated pair by pair: a chain of segments, a triangle mesh. Normalised to order p where the
/// sets are, but where they meet. Throws `InvalidArgument` for none, or p out of 1 to 64.
Field joined(const std::vector<ThinSet>& sets, int p = 2);
/// The chain of segments through the points, joined.
Field polyline_function(const std::vector<Point>& points, int dimension = 2, int p = 2);
/// Several sets as one, with these as its `parts`. Throws as `joined`.
ThinSet composite_set(std::vector<ThinSet> parts);

}  // namespace rfm
