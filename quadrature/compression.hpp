#pragma once

#include "quadrature/quadrature_points.hpp"

namespace rfm {

/// The largest total degree k whose polynomials number at most points^dimension: what a rule of
/// that many points can keep exactly. In 2D 1, 2, 4, 5, 7 for 2 to 6 points, in 3D 1, 3, 5, 7, 8.
int compressed_degree(int points, int dimension);

/// Replaces the points `begin` and later by some of them with new, positive weights, so that all
/// sums of polynomials of total degree ≤ `degree` stay the same: at most as many as there are such
/// polynomials. That such a choice exists is V. Tchakaloff's theorem (1957) by C. Carathéodory's
/// argument, which is the method: along a vector of the null space of the moments the weights are
/// moved until one of them vanishes. Polynomials are Legendre's products over the box of the
/// points, so that a sliver is as exact relative to itself as a whole cell. Errors of smooth
/// integrands become O(h^(degree + 1)) relative to the measure of the points.
///
/// Costs O(n m²) for n points and m polynomials: much more than the points themselves.
void compress(int dimension, int degree, int begin, VolumePoints& points);

}  // namespace rfm
