#pragma once

#include "core/thin_set.hpp"
#include "problems/scalar_problem.hpp"

namespace rfm {

/// ∫ f ds over the part of a curve or surface that lies in the domain, and the measure of that
/// part, on the cells of `grid`: to the order of quadrature on boundaries. Throws
/// `ComputationError` where f is not finite.
std::array<double, 2> integrated_over_set(const Field& f, const ThinSet& set,
                                          const ScalarProblem& problem, const Grid& grid);

/// Points of a rule on that part of the set.
std::vector<Point> points_of_set(const ThinSet& set, const ScalarProblem& problem,
                                 const Grid& grid);

}  // namespace rfm
