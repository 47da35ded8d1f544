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

/// One flag per cell of the grid: whether the region meets it in more than a touch, for a space of
/// splines of `degree`. Where a curved boundary reaches a height ε beyond a grid line it cuts off a
/// cap; splines that live on caps alone have there the values of polynomials that differ by powers
/// of √ε, and make the system singular to working precision (for degree 3 in space from ε = 10⁻⁴ of
/// a cell on). Such cells are left out, and with them their splines, as soon as this costs nothing:
/// the energy of a spline on a part f of a cell is f^(1 + 4 (degree − 1) / (d + 1)) of its whole,
/// and below 10⁻²⁴ (in space 10⁻¹⁷) of the largest it goes. Slivers along flat sides lose less
/// still. In a region that is thinner than every cell all parts are small, and none goes.
std::vector<std::uint8_t> cells_in_region(const DomainRule& rule, int degree = 1);

/// The quadratic energy Σ ∫ (½ dᵀ C d − bᵀ d) as a function of the coefficients of the undetermined
/// functions:
///
/// - `structures[c]` is component c of the solution, affine in the undetermined functions;
/// - `spaces[k]` holds undetermined function k; all share the grid of `rule`, degrees may differ;
/// - `contributions` are integrated with `rule`: those over the volume with its points in cells,
///   those over the boundary with its boundary points.
///
/// The matrix is symmetric (its lower triangle is returned) unless a contribution has couplings;
/// unknowns are ordered function by function. Parallel over tiles of cells; the result does not
/// depend on the number of threads. Cost on one core, with u = ω Ψ and two or three slots:
/// about 2.5 µs per cell inside for degree 3 in the plane, 10 µs for degree 2 in space. Throws
/// `InvalidArgument` when grids differ or an unknown or component does not exist, and
/// `ComputationError`, with the point and the name of the quantity, where a coefficient is not
/// finite.
LinearSystem assemble(std::span<const Structure> structures,
                      std::span<const TensorProductSpace> spaces,
                      std::span<const Contribution> contributions, const DomainRule& rule,
                      const FieldArguments& arguments = {});

}  // namespace rfm
