#pragma once

#include <array>
#include <vector>

#include "core/field.hpp"

namespace rfm {

/// The sampled fields in an expression, at their own points or at mapped ones, each node once.
std::vector<const Field::Node*> sources_of(const Field& field);

/// Coordinates along each axis where the sampled fields in an expression are not smooth, ascending:
/// quadrature splits cells there. Of a field at mapped points μ(x) they are known where the
/// component of μ is affine in one coordinate, μᵢ = a xⱼ + b: then they are (knot − b) / a. Other
/// maps bend knots into curves, at which cells cannot be split: integrals of such fields converge
/// as the smoothness of the spline lets them.
std::array<std::vector<double>, 3> source_breakpoints(const Field& field, int dimension);

}  // namespace rfm
