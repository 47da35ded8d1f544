#pragma once

#include "core/thin_set.hpp"
#include "problems/extremes.hpp"
#include "problems/scalar_problem.hpp"

namespace rfm {

/// The largest value of a field over the part of a curve, surface or segment that lies in the
/// domain: the best point of a rule on it, improved by Newton's method on the conditions of
/// Lagrange along the set, at its ends and where it leaves the domain, as `maximum_over_volume`.
/// Throws `ComputationError` if no point of the set lies in the domain, or a value is not finite.
Extreme maximum_over_set(const Field& f, const ThinSet& set, const ScalarProblem& problem,
                         const Grid& grid);

}  // namespace rfm
