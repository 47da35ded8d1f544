#pragma once

#include <string>
#include <vector>

#include "problems/boundary_conditions.hpp"
#include "problems/structure_language.hpp"
#include "solution_structures/structure.hpp"

namespace rfm {

/// A solution structure of the user's own: `discretization.structure`, in the language of
/// problems/structure_language.hpp.
struct UserStructure {
  std::string text;
  Structure structure;
  Place place;
};

/// By unknown; empty where the file has none. Of several unknowns c there is a formula each, in
/// which psi1 … psi_c are what the unknowns are made of, in their order, and share their degrees.
/// `cell` is the shortest side of a cell (`near`). Throws `ProblemFileErrors` where a text has no
/// meaning or is not affine in the undetermined functions, and where an unknown has none.
std::vector<UserStructure> user_structures(const Problem& problem, const CellSides& cell);

}  // namespace rfm
