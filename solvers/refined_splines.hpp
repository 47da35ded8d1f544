#pragma once

#include <span>

#include "basis/tensor_product_space.hpp"
#include "solvers/extraction.hpp"

namespace rfm {

/// Splines of grids of their own as combinations of those of one common grid: function k of a
/// problem has the space `own[k]` and is assembled in `common[k]`, of the same degree, whose grid
/// has all lines of the former's within its box. Coefficients are those of knot insertion, the
/// blossom of each spline at the inner knots of the common ones (L. Ramshaw, Blossoming, 1987).
/// Splines of the common grid beyond the box of a function's own have no part in it: what it
/// multiplies vanishes there.
///
/// So functions on several grids, as of a domain and of windows in it, have one rule of quadrature
/// in whose cells all are polynomials, and one system. Throws `InvalidArgument` where degrees
/// differ or a line of an own grid is missing.
SplineExtraction refined_splines(std::span<const TensorProductSpace> own,
                                 std::span<const TensorProductSpace> common);

}  // namespace rfm
