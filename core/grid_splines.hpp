#pragma once

#include "core/bspline.hpp"
#include "core/grid.hpp"

namespace rfm {

// B-splines along the axes of a grid, whose knots are its lines, continued beyond the box with the
// widths of the outermost cells (`Grid::knot`). Numbers as in core/bspline.hpp: spline j lies over
// the cells j − p … j, and local function i of cell c is spline c + i. Where all cells are equal
// these are its uniform splines, bit by bit; else the recurrence of Cox and de Boor with the
// distances of knots,
//
//     B^q_i(x) = (x − t_i)/(t_{i+q} − t_i) · B^{q−1}_i(x)
//              + (t_{i+q+1} − x)/(t_{i+q+1} − t_{i+1}) · B^{q−1}_{i+1}(x),
//
// whose terms are positive, too. Splines of degree p have approximation order p + 1 in the width of
// the cells for any widths. Source: C. de Boor, A Practical Guide to Splines (2001), chapters IX
// and X.

/// Values and derivatives up to `order` of the degree + 1 splines of a cell at the place `s` ∈ [0,
/// 1] in it, as the `evaluate_bsplines` of equal cells returns them: derivatives are those by
/// x / grid.spacing(axis). Throws `InvalidArgument` unless 0 ≤ degree ≤ 8 and order ≥ 0.
void evaluate_bsplines(const Grid& grid, int axis, int cell, int degree, int order, double s,
                       double* values);

/// The mean of the inner knots of a spline: the coefficients of x itself.
double greville_point(const Grid& grid, int axis, int degree, int spline);

/// `bernstein_from_bsplines` of the splines of a cell.
BlossomMatrix bernstein_from_bsplines(const Grid& grid, int axis, int cell, int degree, double low,
                                      double high);

/// The coefficients of the derivative by x in the splines of one degree less, row by row.
BlossomMatrix derivative_coefficients(const Grid& grid, int axis, int cell, int degree);

}  // namespace rfm
