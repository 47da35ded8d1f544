#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/thin_set.hpp"
#include "problems/boundary_conditions.hpp"
#include "problems/scalar_physics.hpp"
#include "quadrature/domain_rule.hpp"
#include "solution_structures/verification.hpp"

namespace rfm {

/// By how much structures (by unknown) miss a condition on its piece of the boundary at most, for
/// undetermined functions chosen at random and for none, at the boundary points of `rule`; `scale`
/// is the size of what the condition is made of: values and how far u is from them inside, slopes
/// of u. Of a clamped piece the normal derivative counts, too; natural conditions are divided by
/// the conductivity along the normal. Nothing where there are no points.
std::optional<StructureDeviation> deviation_from(const PieceCondition& condition,
                                                 const std::vector<Structure>& structures,
                                                 const ScalarCoefficients& coefficients,
                                                 const DomainRule& rule,
                                                 const RegionEvaluator& region);

/// The same of the value of an unknown on a set, at points of it near those of `rule`. Nothing
/// where none are found, as of segments in space.
std::optional<StructureDeviation> deviation_from(const ThinSet& set, int unknown,
                                                 const Field& value,
                                                 const std::vector<Structure>& structures,
                                                 const DomainRule& rule);

/// Whether points of the domain, of those of a rule, are near a set: within two cells.
bool reaches(const ThinSet& set, const DomainRule& rule);

/// Whether a deviation is rounding, by its scale. One that is not a number is none.
bool is_met(const std::optional<StructureDeviation>& deviation);

/// "it is 0.3 off at (1, 2) for an arbitrary psi".
std::string deviation_text(const StructureDeviation& deviation, int dimension);

}  // namespace rfm
