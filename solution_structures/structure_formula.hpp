#pragma once

#include "core/field.hpp"
#include "solution_structures/structure.hpp"

namespace rfm {

/// The structure that a formula in Ψ_0, Ψ_1, … is (undetermined.hpp): the sum g + Σ a ∂^β Ψ_k by
/// the product rule, node by node. The formula may add, subtract and differentiate what contains a
/// Ψ, multiply and divide it by what does not, and choose between such expressions. Throws
/// `InvalidArgument` where it is not affine: a product of two, a function of one, Ψ in a divisor,
/// at another point, or differentiated along the time.
Structure structure_of(const Field& formula);

}  // namespace rfm
