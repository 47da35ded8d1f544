#pragma once

#include <vector>

#include "problems/boundary_conditions.hpp"
#include "problems/problem.hpp"
#include "solvers/integrand.hpp"

namespace rfm {

/// −∇·(K ∇u) + advection·∇u + reaction u = source, with coefficients that may jump between
/// materials and may contain u as a symbol (problems/solution_symbols.hpp).
struct ScalarCoefficients {
  std::vector<Field> conductivity;  ///< K row by row, dimension² entries, symmetric
  Field reaction = 0.0;
  Field source = 0.0;
  std::vector<Field> advection;  ///< empty for none
  /// Of eigenvalues: −∇·(K ∇u) + reaction u = λ m u.
  Field mass = 1.0;
};

/// Whether a coefficient contains the solution.
bool depend_on_solution(const ScalarCoefficients& coefficients);

/// The coefficients of `poisson`, `heat`, `torsion` and `membrane` as fields, materials chosen
/// point by point.
ScalarCoefficients scalar_coefficients(const Problem& problem);

/// Whether K is a multiple of the unit matrix.
bool is_isotropic(const ScalarCoefficients& coefficients, int dimension);

/// K ∇f.
std::vector<Field> conductive_flux(const ScalarCoefficients& coefficients, const Field& f,
                                   int dimension);

/// ½ ∫ (∇u·K∇u + reaction u²) − ∫ source u.
Contribution volume_energy(const ScalarCoefficients& coefficients, int dimension);

/// ½ ∫ m u².
Contribution mass_energy(const ScalarCoefficients& coefficients);

/// The boundary terms of a natural condition, with ∂u/∂n the outward derivative: `flux` q = n·K∇u
/// gives −∫ q u; `convection` n·K∇u = h (u∞ − u) gives ∫ (½ h u² − h u∞ u); `robin`
/// a u + b ∂u/∂n = c is n·K∇u = k (c − a u)/b for K = k times the unit matrix (with another K the
/// condition is not natural: it does not follow from an energy). Nothing for a homogeneous flux.
std::vector<Contribution> natural_energy(const PieceCondition& condition,
                                         const ScalarCoefficients& coefficients);

/// Nitsche's terms for u = g: −∫ (u − g) n·K∇u + ½ ∫ β k (u − g)², with β the `penalty` per length.
/// Symmetric and consistent, so of full order; stable for β large enough, and solved as an
/// indefinite system where cut cells make it not so (the solution stays accurate).
Contribution nitsche_energy(const PieceCondition& condition, const ScalarCoefficients& coefficients,
                            int dimension, double penalty);

}  // namespace rfm
