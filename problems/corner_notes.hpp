#pragma once

#include <string>
#include <vector>

#include "problems/boundary_conditions.hpp"
#include "problems/natural_structure.hpp"

namespace rfm {

/// What is worth telling of places where pieces of the boundary meet, a line for each kind: values
/// that contradict each other there, values of different formulas by structure, whose interpolant
/// has no continuous slope there, and fluxes by structure at reentrant corners or smooth joints (in
/// space at any edge), where corrections are rough. Each names the first place. `conditions` are
/// all of a problem, `natural` those by structure; `own` that it is a structure of the user's own,
/// of which only contradictions are told.
std::vector<std::string> corner_notes(const std::vector<PieceCondition>& conditions,
                                      const std::vector<PieceCondition>& values_by_structure,
                                      const std::vector<NaturalPiece>& natural, bool own,
                                      const RegionEvaluator& region, const Box& bounds);

}  // namespace rfm
