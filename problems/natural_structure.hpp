#pragma once

#include <optional>
#include <vector>

#include "problems/boundary_conditions.hpp"
#include "problems/scalar_physics.hpp"
#include "problems/structure_language.hpp"
#include "quadrature/grading.hpp"
#include "solution_structures/condition_part.hpp"
#include "solution_structures/structure.hpp"

namespace rfm {

/// A natural condition that holds by structure, and the function that vanishes on its piece: smooth
/// across it, positive inside, normalised.
struct NaturalPiece {
  PieceCondition condition;
  Field omega;
};

/// The natural conditions among `conditions` that are to hold by structure (`enforce: structure`).
/// Throws `ProblemFileErrors` with the place of those that no structure has: data or coefficients
/// that contain the solution, that jump between materials, or that are undefined inside the domain;
/// functions of the whole domain. Functions of pieces that are steeper or flatter than 1 on the
/// boundary points of `rule` are normalised.
std::vector<NaturalPiece> natural_pieces(const std::vector<PieceCondition>& conditions,
                                         const Problem& problem,
                                         const ScalarCoefficients& coefficients,
                                         const RegionEvaluator& region, const Box& bounds,
                                         const DomainRule& rule);

/// A structure w, corrected next to these pieces so that it satisfies their conditions, too:
///
///     w − Σᵢ χᵢ ωᵢ d²/(d² + ωᵢ²) Rᵢ(w) + Ψ ω₀ Σᵢ χᵢ ωᵢ²
///
/// (`corrected` of solution_structures/condition_part.hpp), ω₀ and d being zero where w
/// takes prescribed values. The cutoffs χ are `faded` with a
/// width of one and a half cells, told as calls to be written `near(omega, 1.5)`. Ψ has the number
/// `remainder`.
struct NaturalStructure {
  Structure structure;
  std::vector<Structure::Call> calls;
};
NaturalStructure with_natural_conditions(const Structure& w,
                                         const std::optional<PrescribedValues>& values,
                                         const std::vector<NaturalPiece>& pieces,
                                         const ScalarCoefficients& coefficients, const Box& bounds,
                                         const CellSides& cell, int remainder);

/// Where corrections meet one another, or prescribed values, they are not smooth: their slopes have
/// limits that depend on the direction. Rules graded towards such corners and ends of pieces in the
/// plane make integrals of products with smooth functions right to 10⁻⁹ of a cell; energies are
/// wrong to first order in h otherwise. None in space, where it would be along edges.
std::vector<Grading> natural_gradings(const std::vector<NaturalPiece>& pieces,
                                      const RegionEvaluator& region, const Box& bounds);

}  // namespace rfm
