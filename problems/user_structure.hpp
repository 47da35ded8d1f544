#pragma once

#include <optional>
#include <string>
#include <vector>

#include "problems/boundary_conditions.hpp"
#include "quadrature/domain_rule.hpp"
#include "solution_structures/structure.hpp"

namespace rfm {

/// A solution structure of the user's own: `discretization.structure`, in the language of
/// `define_structures` (solution_structures/structure_text.hpp) and with all names of the file.
struct UserStructure {
  std::string text;
  Structure structure;
};

/// Nothing where the file has none. Throws `ProblemFileErrors` where the text has no meaning or is
/// not affine in the undetermined functions, and for problems of several unknowns.
std::optional<UserStructure> user_structure(const Problem& problem);

/// Whether the structure takes all values that are to be enforced by structure, for undetermined
/// functions chosen at random, at the boundary points of `rule`. Throws `ProblemFileErrors` with
/// the piece, the place and the difference where it does not.
void require_values(const UserStructure& user, const std::vector<PieceCondition>& conditions,
                    const Problem& problem, const DomainRule& rule);

}  // namespace rfm
