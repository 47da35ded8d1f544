#pragma once

#include <optional>
#include <vector>

#include "problems/boundary_conditions.hpp"
#include "problems/problem.hpp"
#include "problems/scalar_physics.hpp"
#include "quadrature/domain_rule.hpp"
#include "solution_structures/structure.hpp"

namespace rfm {

/// `remainder: formula`: what multiplies the undetermined function, in the place of ω (Shapiro
/// 2007, section 7.3: behaviour that is known beforehand).
struct RemainderOption {
  Field factor;
  Place place;
};
/// Throws `ProblemFileErrors` where the formula is wrong.
std::optional<RemainderOption> remainder_option(const Problem& problem);

/// Throws `ProblemFileErrors` unless the structure that was made with it takes the values of
/// `plan` and leaves something to be solved.
void check_remainder(const RemainderOption& remainder, const Problem& problem,
                     const std::vector<DirichletPlan>& plans,
                     const std::vector<Structure>& structures,
                     const ScalarCoefficients& coefficients, const DomainRule& rule,
                     const RegionEvaluator& region);

/// What the user should know: that it changes its sign inside the domain.
std::optional<std::string> remainder_note(const RemainderOption& remainder, const DomainRule& rule);

}  // namespace rfm
