#pragma once

#include "problems/problem.hpp"
#include "quadrature/domain_rule.hpp"

namespace rfm {

/// A region (of a condition or a probe) whose `where` is no number somewhere on its pieces is a
/// mistake: neither inside nor outside is meant there. Tried at the points of the rule; the message
/// names one and the operation that fails. Throws `ProblemFileErrors`.
void check_regions_are_defined(const Problem& problem, const RegionEvaluator& region,
                               const DomainRule& rule);

}  // namespace rfm
