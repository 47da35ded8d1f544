#pragma once

#include <vector>

#include "core/field.hpp"
#include "core/spline_field.hpp"

namespace rfm {

// Splines through given values: how a sampled field (a distance, a measured temperature) becomes a
// field with derivatives. Interpolation at the Greville points is of order degree + 1 in the
// spacing of the grid, and exact for polynomials of the degree in each coordinate. For degree 1 the
// points are the grid lines. Source: C. de Boor, A Practical Guide to Splines (2001), chapter XIII.

/// The cells(axis) + degree abscissae along an axis: averages of `degree` consecutive knots, knots
/// beyond the grid moved to its ends; for degree 0 the middles of cells. Ascending, the first and
/// last are the ends of the grid.
std::vector<double> interpolation_points(const Grid& grid, int axis, int degree);

/// The spline with these values at the tensor product of the interpolation points, x running
/// fastest. Throws `InvalidArgument` on a degree outside 0 … 8, a wrong number of values, or one
/// that is not finite.
SplineField interpolate(const Grid& grid, int degree, const std::vector<double>& values);

/// The spline through the values of `field` at the interpolation points. Throws
/// `ComputationError` where the field has no finite value, with the reason.
SplineField sample(const Field& field, const Grid& grid, int degree);

}  // namespace rfm
