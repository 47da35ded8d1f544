#pragma once

#include <string>
#include <utility>
#include <vector>

#include "core/expression.hpp"
#include "solution_structures/structure.hpp"

namespace rfm {

/// Fields that are written by name: {"omega(hole)", ω}, {"load", f}.
using StructureNames = std::vector<std::pair<std::string, Field>>;

/// The formula of a structure as one line, in the language of problem files:
///
///     psi1 - omega(hole)*D(omega(hole), psi1) + omega(hole)^2*psi2
///
/// Ψ_0, Ψ_1, … are `psi1`, `psi2`, …. Read in a scope of `define_structures` in which the names
/// have their meaning, it is the same function. Throws as `to_text` of fields does.
std::string to_text(const Structure& structure, const StructureNames& names = {});

/// Gives formulas of `scope` what structures are written with: `psi1` … for so many undetermined
/// functions (one is `psi`, too), and
///
///     D(omega, f)                         ∇ω·∇f
///     normalizer(f, omega)                f(x − ω∇ω), eq. (7.2) of Shapiro (2007)
///     transfinite(p1, omega1, mu1, …)     Σ pᵢ ωᵢ^−μᵢ / Σ ωᵢ^−μᵢ, eq. (7.10)
///
/// beside the derivatives `dx(f)`, `grad(f)`, … of `define_derivatives`, which is called.
void define_structures(ExpressionScope& scope, int dimension, int unknowns);

/// The structure that a text is. Throws `InputError` where the text has no meaning in `scope`, and
/// over the whole of it where it is not affine in the Ψ.
Structure to_structure(const Expression& text, const ExpressionScope& scope);

}  // namespace rfm
