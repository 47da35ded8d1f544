#pragma once

#include <array>
#include <span>

#include "basis/tensor_product_space.hpp"
#include "solvers/extraction.hpp"

namespace rfm {

/// Splines that repeat along some axes with the length of the grid's box: of N cells along an axis
/// the splines i and i + N, i < degree, are one. Across the sides of the box they are degree − 1
/// times differentiable, too. Throws `InvalidArgument` where there are fewer cells along such an
/// axis than the degree, or cells are not equal.
SplineExtraction periodic_splines(std::span<const TensorProductSpace> spaces,
                                  const std::array<bool, 3>& axes);

}  // namespace rfm
