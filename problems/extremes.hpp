#pragma once

#include "core/tape.hpp"
#include "problems/scalar_problem.hpp"

namespace rfm {

struct Extreme {
  double value = 0;
  Point at{};
};

/// The largest value of a field over the volume (where `inside` is ≥ 0, if given): the best of all
/// quadrature points, improved by Newton's method on ∇f = 0 while it stays in the region, and of
/// all boundary points, improved along the boundary.
Extreme maximum_over_volume(const Field& f, const ScalarProblem& problem, const DomainRule& rule,
                            const std::optional<Field>& inside = {});

/// The largest value over pieces of the boundary: the best boundary point, improved by golden
/// section along the curve between its neighbours (in 2D; elsewhere the best point is taken).
Extreme maximum_over_boundary(const Field& f, const ScalarProblem& problem, const DomainRule& rule,
                              const std::vector<int>& primitives,
                              const std::optional<Field>& where = {});

}  // namespace rfm
