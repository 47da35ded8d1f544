#pragma once

#include <string>
#include <vector>

#include "problems/problem.hpp"

namespace rfm {

/// A condition that claims a piece of the boundary, or the part of it where `where` ≥ 0.
struct PieceClaim {
  int condition = 0;
  std::optional<Field> where;
  /// Whether only measures tell how much of the piece it holds.
  bool chosen_by_geometry = false;
};

/// Who rules where on one piece (a primitive that bounds the domain): at a point, the first claim
/// in the list whose `where` is ≥ 0 there, by falling priority.
struct PieceConditions {
  std::string piece;
  std::vector<PieceClaim> claims;
  /// Whether the claims certainly cover the piece: the last one has no `where`. If not, the points
  /// that no claim reaches have no condition, which only evaluation can tell.
  bool is_covered = false;
};

/// Distributes the conditions of a problem over pieces of its boundary, given by name.
std::vector<PieceConditions> assign_conditions(const Problem& problem,
                                               const std::vector<std::string>& pieces);

/// Checks the conditions against the pieces that really bound the domain, which the reader cannot
/// know: a piece without any condition, and a condition at parts that do not bound the domain, are
/// mistakes. (`rest` may be empty; whether parts of pieces cover them, and whether two of them
/// overlap, is for the caller to evaluate: see `PieceConditions`.) Throws `ProblemFileErrors`.
void check_boundary_coverage(const Problem& problem, const std::vector<std::string>& pieces);

/// Conditions of equal priority that claim the same piece as a whole, or a whole and a part of it.
/// Called by the reader: names alone decide.
void check_overlaps(const Problem& problem, MistakeList& mistakes);

}  // namespace rfm
