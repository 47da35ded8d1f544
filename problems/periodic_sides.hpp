#pragma once

#include <array>
#include <span>
#include <vector>

#include "problems/problem.hpp"
#include "quadrature/domain_rule.hpp"
#include "solution_structures/structure.hpp"

namespace rfm {

/// `{at: box.left, periodic: {to: box.right}}`: u is the same on both sides, which are opposite
/// sides of the box of the grid, and goes on smoothly from one to the other.
struct PeriodicPair {
  int first = 0, second = 0;  ///< primitives
  int axis = 0;
  Place place;
};

/// Throws `ProblemFileErrors` unless the sides are opposite sides of the box, seen from the points
/// of `rule`.
std::vector<PeriodicPair> periodic_pairs(const Problem& problem, const Region& region,
                                         const DomainRule& rule);

/// The axes along which splines repeat.
std::array<bool, 3> periodic_axes(std::span<const PeriodicPair> pairs);

/// Throws `ProblemFileErrors` unless the fields of which structures are made are the same on both
/// sides: with periodic functions Ψ the solution is then periodic.
void check_periodic(const std::vector<Structure>& structures, std::span<const PeriodicPair> pairs,
                    const DomainRule& rule);

}  // namespace rfm
