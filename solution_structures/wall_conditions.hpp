#pragma once

#include <optional>
#include <vector>

#include "core/field.hpp"
#include "solution_structures/vector_structure.hpp"

namespace rfm {

// Conditions on vectors: displacements, velocities. ν = ∇ω is the inward normal where ω = 0; data
// are for the outward one. Numbers of components are that of the space.

/// u = displacement where ω = 0: u = g + ω Ψ, component by component. A component without a value
/// is free: Ψ itself.
std::vector<Structure> displacement(const Field& omega,
                                    const std::vector<std::optional<Field>>& values,
                                    int first_unknown = 0);

/// u·n = value where ω = 0, on a wall of any shape, the tangential part being free (a roller):
/// u = Ψ − χ ν (ν·Ψ + value) + χ ω ν Φ. Uses as many functions as there are components, and Φ. With
/// a cutoff χ (as in `corrected`) Φ needs splines near the wall only; without, Φ and ν·Ψ describe
/// the same thing, and systems are singular.
std::vector<Structure> normal_displacement(const Field& omega, const Field& value, int dimension,
                                           const Field& cutoff = 1.0, int first_unknown = 0);

/// A plane of symmetry, where ω is flat: no normal displacement and no normal derivative of the
/// tangential one. With R = Ψ − ν (ν·Ψ), u = R − ω (D R − ν (ν·D R)) + ω ν χ + ω² Φ, which uses
/// 2 d + 1 functions. Where shear is natural, `normal_displacement` is enough.
std::vector<Structure> symmetry(const Field& omega, int dimension, int first_unknown = 0);

}  // namespace rfm
