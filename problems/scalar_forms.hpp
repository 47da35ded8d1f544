#pragma once

#include <vector>

#include "problems/boundary_conditions.hpp"
#include "problems/scalar_physics.hpp"
#include "solvers/form.hpp"

namespace rfm {

/// How equations without an energy, and those whose coefficients depend on the solution, are
/// written as forms (solvers/form.hpp). u is the unknown's symbol.
///
/// The volume: by Galerkin's method ∇v·K∇u + v (a·∇u + reaction u − source); by least squares the
/// strong residual −∇·(K∇u) + a·∇u + reaction u − source.
Form volume_form(const ScalarCoefficients& coefficients, int dimension, bool least_squares);

/// n·K∇u − q(u) of a natural condition, q as in `natural_energy`; of an oblique derivative
/// n·Kn (l·∇u − c), which has a meaning for directions along the boundary, too.
Field natural_residual(const PieceCondition& condition, const ScalarCoefficients& coefficients,
                       const std::vector<Field>& normal, const Field& u);
/// n·K n.
Field normal_conductivity(const ScalarCoefficients& coefficients, const std::vector<Field>& normal);

/// A natural condition n·K∇u = q(u), q as in `natural_energy`, of an oblique derivative l·∇u = c
/// q = n·K∇u − (n·Kn)/(l·n) (l·∇u − c), in which ∂u/∂n cancels: −q v, or the residual n·K∇u − q
/// with the weight 1/h, which makes its square as large as that of the equation for splines of size
/// h. Nothing for q = 0 by Galerkin's method.
std::vector<Form> natural_forms(const PieceCondition& condition,
                                const ScalarCoefficients& coefficients,
                                const std::vector<Field>& normal, bool least_squares, double h);

/// u = g in least squares: the residual k (u − g), k = n·K n, with the weight 1/h³.
Form value_residual(const PieceCondition& condition, const ScalarCoefficients& coefficients,
                    const std::vector<Field>& normal, double h);

/// The place of a condition's piece.
FormPlace form_place(const PieceCondition& condition);

}  // namespace rfm
