#pragma once

#include "core/region.hpp"

namespace rfm {

// Signed Euclidean distances, positive inside: what `exact: true` puts in place of the functions of
// core/primitives.hpp. |∇| = 1 everywhere off the skeleton of the shape, where they have kinks: its
// centre, axis or middle, or the focal set of an ellipse. Signs are those of the primitives'
// levels.

/// r − |x − c| of a circle (dimension 2) or sphere (3).
Field ball_distance(const Point& center, double radius, int dimension);
/// r − ρ, from the axis through `center`: of the side of a cylinder.
Field cylinder_distance(const Point& center, const Point& axis, double radius);
/// h sin − ρ cos, the distance from the lines of a cone's side; beyond its apex (outside, opposite
/// to the axis) smaller than the distance from the apex.
Field cone_distance(const Point& apex, const Point& axis, double half_angle);
/// r − |(ρ − R, h)| of a torus.
Field torus_distance(const Point& center, const Point& axis, double radius, double tube);
/// r − s, s the distance from the segment.
Field capsule_distance(const Point& from, const Point& to, double radius);

/// The distance from an ellipse or ellipsoid about the origin with its half axes along the
/// coordinates, for `compose` (`EllipsoidDistance`). The foot p of x solves pᵢ = aᵢ² xᵢ / (t + aᵢ²)
/// with the largest root t of Σ (aᵢ xᵢ / (t + aᵢ²))² = 1, found by Newton's method from its left,
/// where it converges monotonically; the distance is −t √Σ (xᵢ/(t + aᵢ²))². Derivatives of every
/// order follow by Newton's method on jets, which doubles the order that is right (implicit
/// differentiation). On the focal set derivatives are 0 by convention. Throws `InvalidArgument`
/// unless the radii are positive and the dimension is 2 or 3.
Field ellipsoid_distance(const Point& radii, int dimension);
/// The same about `center`, turned by `angle` (radians) about `axis`.
Field ellipsoid_distance(const Point& center, const Point& radii, const Point& axis, double angle,
                         int dimension);

/// Of a box in 1 to 3 dimensions: min over its sides inside, −|q| outside, where component i of q
/// is how far the point is out along axis i. Kinks where two sides are nearest, inside.
Field box_distance(const Point& min, const Point& max, int dimension);
/// Of a strip: the smaller of those from its two sides.
Field strip_distance(const Point& point, const Point& normal, double width);
/// Of a sector (core/primitives.hpp), by `contour_distance`.
Field sector_distance(const Point& center, double radius, double from, double to,
                      double inner_radius);

/// The region with the distance r − |x − c| for the function of each primitive that is a circle or
/// a sphere; planes have it as it is.
Region with_exact_sides(const Region& region);

/// The region with `function` for that of its first primitive.
Region with_function(const Region& region, const Field& function);

}  // namespace rfm
