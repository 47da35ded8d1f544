#pragma once

#include "problems/boundary_conditions.hpp"
#include "problems/structure_options.hpp"
#include "quadrature/domain_rule.hpp"
#include "solution_structures/structure.hpp"

namespace rfm {

/// What the structure of unknown `component` becomes with conditions inside the domain. Of the plan
/// g + ω Ψ it makes
///
///     g' + ω Π σᵢ Ψ + ω Σ γᵢ Π' σⱼ Ψᵢ + ω Π σᵢ Σ |κₖ| Ψₖ ,
///
/// g' taking also the values on the sets σᵢ = 0 (7.12). Of curves σ = |γ| makes slopes of both
/// sides opposite; with γ they are free of each other (only where the domain has both sides). κₖ =
/// 0 is an interface of materials, where the slope jumps freely; where u itself jumps, g' gains
/// jump H(κ) ω/(ω + κ²). `plan` is told the new g and ω. Functions beyond the unknowns' own are
/// numbered from `functions` on, which is advanced. `rule` tells which sides of sets lie in the
/// domain.
Structure with_inner_conditions(DirichletPlan& plan, int component, const StructureOptions& options,
                                const DomainRule& rule, const Box& bounds, int& functions);

/// A singular function at a corner, where it satisfies the homogeneous conditions of both sides.
struct SingularTerm {
  Field factor;  ///< r^α sin αθ or r^α cos αθ, fading away from the corner
  std::string text;
};

/// The singular functions that an enrichment asks for. θ runs over the angle between the two sides
/// of the boundary at the point, which must be straight as far as the window reaches: sines vanish
/// on a side with values, cosines have no flux through one without. By `auto` the first three
/// exponents that are no whole numbers. The window fades before it reaches any other part of the
/// boundary. Throws `ProblemFileErrors` for points off the boundary and curved sides.
std::vector<SingularTerm> singular_terms(const Enrichment& enrichment,
                                         const std::vector<PieceCondition>& conditions,
                                         const RegionEvaluator& region, const DomainRule& rule);

}  // namespace rfm
