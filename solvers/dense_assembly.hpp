#pragma once

#include <memory>
#include <span>

#include "basis/global_space.hpp"
#include "quadrature/domain_rule.hpp"
#include "solution_structures/structure.hpp"
#include "solvers/field_arguments.hpp"
#include "solvers/integrand.hpp"
#include "solvers/linear_system.hpp"

namespace rfm {

using GlobalSpaces = std::vector<std::shared_ptr<const GlobalSpace>>;

/// The same system as that of `assemble` (solvers/assembly.hpp), for functions that all live on the
/// whole domain: points are taken in batches, and each adds dense products. The grid of `rule` is
/// one of quadrature only. The matrix is full (of a symmetric one the lower triangle is returned);
/// n functions cost n² times the number of points. Parallel; the result does not depend on the
/// number of threads. Throws as `assemble` does.
LinearSystem assemble_dense(std::span<const Structure> structures, const GlobalSpaces& spaces,
                            std::span<const Contribution> contributions, const DomainRule& rule,
                            const FieldArguments& arguments = {});

}  // namespace rfm
