#pragma once

#include <span>

#include "quadrature/domain_rule.hpp"
#include "solvers/field_arguments.hpp"
#include "solvers/integrand.hpp"

namespace rfm {

/// The value of a contribution for a given solution: ∫ (½ dᵀ C d − bᵀ d) over its place, with d the
/// derivatives of `components` that it uses. Where the components are those of
/// `solution_fields(…, c)`, the sum over all contributions is `LinearSystem::energy(c)`.
/// Throws `InvalidArgument` if a slot's component does not exist.
double energy(const Contribution& contribution, std::span<const Field> components,
              const DomainRule& rule, const FieldArguments& arguments = {});

}  // namespace rfm
