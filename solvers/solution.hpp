#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "basis/tensor_product_space.hpp"
#include "core/field.hpp"
#include "solution_structures/structure.hpp"

namespace rfm {

/// The undetermined functions Ψ_k as fields: `coefficients` holds those of all spaces, block by
/// block, as `solve` returns them. Throws `InvalidArgument` on a wrong number of coefficients.
std::vector<Field> undetermined_functions(std::span<const TensorProductSpace> spaces,
                                          const Eigen::VectorXd& coefficients);

/// u = g + Σ a ∂^β Ψ: the structure with its undetermined functions put in. Throws
/// `InvalidArgument` if the structure uses a function that is not given.
Field solution_field(const Structure& structure, std::span<const Field> functions);

/// The solution as fields, one per component: it can be differentiated, integrated, drawn, and be
/// data of the next problem.
std::vector<Field> solution_fields(std::span<const Structure> structures,
                                   std::span<const TensorProductSpace> spaces,
                                   const Eigen::VectorXd& coefficients);

}  // namespace rfm
