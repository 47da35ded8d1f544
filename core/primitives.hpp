#pragma once

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
/// The box min ≤ x ≤ max in 1 to 3 dimensions, a conjunction of its sides `left right bottom top
/// back front` (x−, x+, y−, y+, z−, z+), each an exact signed distance.
Region box(const Point& min, const Point& max, int dimension = 2);
/// {f ≥ 0} for any function, taken as it is: not normalised.
Region level_set(const Field& f, int dimension = 2);

}  // namespace rfm
