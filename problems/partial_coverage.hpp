#pragma once

#include "problems/boundary_conditions.hpp"
#include "quadrature/domain_rule.hpp"

namespace rfm {

/// What only the shape can tell of parts of the boundary: a region (of a condition or a probe) that
/// is empty, a part of the
/// boundary that no region reaches, and regions of equal priority that overlap (by more than 10⁻⁹
/// of the boundary's measure) are mistakes. Throws `ProblemFileErrors`. `rule` must be split along
/// the zeros of all `where`.
void check_parts(const Problem& problem, const RegionEvaluator& region,
                 const std::vector<int>& bounding_primitives, const DomainRule& rule);

/// Materials that overlap, and parts of the domain that none covers where the coefficient has no
/// default, are mistakes. Throws `ProblemFileErrors`. `rule` must be split along the boundaries of
/// the materials.
void check_materials(const Problem& problem, const DomainRule& rule);

}  // namespace rfm
