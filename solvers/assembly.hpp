#pragma once

#include <span>
#include <vector>

#include "basis/tensor_product_space.hpp"
#include "quadrature/domain_rule.hpp"
#include "solution_structures/structure.hpp"
#include "solvers/field_arguments.hpp"
#include "solvers/integrand.hpp"
#include "solvers/linear_system.hpp"

namespace rfm {

/// One flag per cell of the grid: whether the region meets it, for the spaces of a problem. In two
/// and three dimensions cells of which less than 10⁻¹⁵ is inside do not count: where a curved
/// boundary touches a grid line, rounding makes a cap of height ε with a part ε^((d + 1)/2) of the
/// cell. Splines that live on such caps alone would be the same function up to rounding (the system
/// would be singular), and without them the energy of the solution changes by less than that part.
std::vector<std::uint8_t> cells_in_region(const DomainRule& rule);

/// The quadratic energy Σ ∫ (½ dᵀ C d − bᵀ d) as a function of the coefficients of the undetermined
/// functions:
///
/// - `structures[c]` is component c of the solution, affine in the undetermined functions;
/// - `spaces[k]` holds undetermined function k; all share the grid of `rule`, degrees may differ;
/// - `contributions` are integrated with `rule`: those over the volume with its points in cells,
///   those over the boundary with its boundary points.
///
/// The matrix is symmetric (its lower triangle is returned); unknowns are ordered function by
/// function. Parallel over tiles of cells; the result does not depend on the number of threads.
/// Cost on one core, with u = ω Ψ and two or three slots: about 2.5 µs per cell inside for degree 3
/// in the plane, 10 µs for degree 2 in space.
/// Throws `InvalidArgument` when grids differ or an unknown or component does not exist, and
/// `ComputationError`, with the point and the name of the quantity, where a coefficient is not
/// finite.
LinearSystem assemble(std::span<const Structure> structures,
                      std::span<const TensorProductSpace> spaces,
                      std::span<const Contribution> contributions, const DomainRule& rule,
                      const FieldArguments& arguments = {});

}  // namespace rfm
