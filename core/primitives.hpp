#pragma once

#include <limits>
#include <vector>

#include "core/region.hpp"

namespace rfm {

// Primitive shapes, unnamed (`Region::named` names them and their sides). `function` is normalised
// to first order: its inward normal derivative is 1 on the boundary. `level` is a polynomial.
// All throw `InvalidArgument` on sizes that are not positive or directions without length.

/// {(x − point) · normal ≥ 0}: normal points inside. An exact signed distance.
Region half_plane(const Point& point, const Point& normal);
/// (r² − |x − c|²) / 2r: a polynomial, normalised to first order; not a distance off the circle.
Region circle(const Point& center, double radius);
/// 1 − (ξ/a)² − (η/b)² in axes turned by `angle` radians, normalised by eq. (4.9).
Region ellipse(const Point& center, const Point& radii, double angle = 0);
/// The band of `width` about the line through `point` across `normal`: the conjunction of two
/// half-planes `low` and `high` (normal points from low to high), each an exact signed distance.
Region strip(const Point& point, const Point& normal, double width);
/// The part of a disk between two angles, from `from` to `to` in radians, less than a full turn
/// apart: sides `arc`, `from`, `to`, and with an inner radius `inner`. Straight sides are exact
/// signed distances; beyond 180° a disjunction, at 180° one side `from_line` (`sector_sides`).
Region sector(const Point& center, double radius, double from, double to, double inner_radius = 0);
/// The box min ≤ x ≤ max in 1 to 3 dimensions, a conjunction of its sides `left right bottom top
/// back front` (x−, x+, y−, y+, z−, z+), each an exact signed distance.
Region box(const Point& min, const Point& max, int dimension = 2);
/// {(x − point) · normal ≥ 0} in space. An exact signed distance.
Region half_space(const Point& point, const Point& normal);
/// (r² − |x − c|²) / 2r in space.
Region sphere(const Point& center, double radius);
/// 1 − Σ (ξᵢ/aᵢ)² in axes turned by `angle` radians about `axis`, normalised by eq. (4.9).
Region ellipsoid(const Point& center, const Point& radii, const Point& axis = {0, 0, 1},
                 double angle = 0);
/// Around the line through `center` along `axis`: side `side`, (r² − ρ²) / 2r with ρ the distance
/// from the axis. With a finite `length`, centred, the conjunction with the half-spaces of its flat
/// ends `start` and `end` (start lies against the axis' direction).
Region cylinder(const Point& center, const Point& axis, double radius,
                double length = std::numeric_limits<double>::infinity());
/// The points h ≥ 0 along `axis` from `apex` with ρ ≤ h tan(half_angle): side `side`, the quadric
/// (h sin)² − (ρ cos)² normalised by eq. (4.9), and the half-space h ≥ 0, which cuts off the other
/// nappe and bounds nothing but the apex. With a finite `length` a flat end `end`.
Region cone(const Point& apex, const Point& axis, double half_angle,
            double length = std::numeric_limits<double>::infinity());
/// The quartic 4R²ρ² − (|x − c|² + R² − r²)², normalised by eq. (4.9); R is the radius of the
/// tube's middle, r < R that of the tube.
Region torus(const Point& center, const Point& axis, double radius, double tube);
/// The points within `radius` of the segment from `from` to `to`: a round rod with round ends,
/// (r² − s²) / 2r with s the distance from the segment. Continuously differentiable; its second
/// derivatives jump where the round ends begin, as the curvature of the surface does.
Region capsule(const Point& from, const Point& to, double radius);
/// {Q ≥ 0} for any polynomial of degree 2, normalised by eq. (4.9): in the plane
/// a x² + b xy + c y² + d x + e y + f, in space the coefficients of x², y², z², xy, xz, yz, x, y,
/// z, 1. Throws `InvalidArgument` unless there are 6 (10 in space) finite ones, not all but the
/// last 0.
Region quadric(const std::vector<double>& coefficients, int dimension = 2);
/// {f ≥ 0} for any function, taken as it is: not normalised. Quadrature takes the simplest function
/// of the same sign (core/same_sign.hpp).
Region level_set(const Field& f, int dimension = 2);

}  // namespace rfm
