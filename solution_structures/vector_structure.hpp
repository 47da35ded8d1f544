#pragma once

#include <vector>

#include "core/field.hpp"
#include "solution_structures/structure.hpp"

namespace rfm {

// Unknowns with several components are vectors of structures, one row each: displacements,
// velocities. All functions throw `InvalidArgument` where numbers of components differ.

/// Ψ_first, Ψ_{first+1}, …: one undetermined function per component.
std::vector<Structure> undetermined_vector(int components, int first = 0);

std::vector<Structure> operator+(const std::vector<Structure>& a, const std::vector<Structure>& b);
std::vector<Structure> operator-(const std::vector<Structure>& a, const std::vector<Structure>& b);
std::vector<Structure> operator*(const Field& factor, const std::vector<Structure>& a);
/// The vector field `direction` times a scalar structure.
std::vector<Structure> operator*(const std::vector<Field>& direction, const Structure& a);
/// Vector fields are affine.
std::vector<Structure> structures(const std::vector<Field>& fields);

/// Σᵢ aᵢ uᵢ.
Structure dot(const std::vector<Field>& a, const std::vector<Structure>& u);
/// Σᵢ ∂uᵢ/∂xᵢ.
Structure divergence(const std::vector<Structure>& u);
/// D(ω, ·) of each component.
std::vector<Structure> D(const Field& omega, const std::vector<Structure>& u, int dimension);

}  // namespace rfm
