#pragma once

#include "core/quadric.hpp"

namespace rfm {

/// First-order normalisation in lengths of l: f / √((f/l)² + |∇f|²), which is l times eq. (4.9) of
/// Shapiro (2007) in the coordinates x/l. Its slope on {f = 0, ∇f ≠ 0} is 1, as with (4.9) itself,
/// and it levels off at l away from the boundary: with l a length of the shape, the function of a
/// shape λ times as large is λ times as large, where (4.9) would level off at 1 in whatever unit.
/// l may be infinite: f / |∇f|, for what has no length of its own, as half-planes and infinite
/// cones. Throws `InvalidArgument` unless l > 0.
Field normalize_within(const Field& f, double length, int dimension);

/// The length that a polynomial t ↦ c + b·t + tᵀAt of degree 2 has by itself: √(|c| / |A|) about
/// its centre, for an ellipse within √2 of its smaller half axis; |b| / |A| of a parabola; infinite
/// for planes, infinite cones and pairs of planes that cross. |A| is the Frobenius norm.
double length_of(const Quadric& quadric);

/// A level function in lengths of itself if it is a polynomial of degree ≤ 2, else of `otherwise`.
Field normalize_by_itself(const Field& level, int dimension, double otherwise = 1);

}  // namespace rfm
