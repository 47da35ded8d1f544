#pragma once

#include <optional>

#include "problems/scalar_problem.hpp"

namespace rfm {

/// By how much ∮ n·K∇u + ∫ (source − reaction u − advection·∇u) misses zero, relative to what
/// enters through single pieces of the boundary and from the source. Integrals of residuals are
/// small where u is one function in the whole domain, and they stay where it is not: at a
/// reentrant corner u has no second derivatives that are square integrable, and the least sum of
/// squares among functions that have is another function (P. Grisvard, Elliptic Problems in
/// Nonsmooth Domains, 1985, chapter 4: there −Δ of H² is closed and not all of L²). Nothing for
/// custom equations, and where values inside the domain are sources.
std::optional<double> flux_imbalance(const ScalarProblem& problem, const ScalarSolution& solution);

}  // namespace rfm
