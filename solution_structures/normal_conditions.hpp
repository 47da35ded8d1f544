#pragma once

#include <vector>

#include "core/field.hpp"
#include "solution_structures/condition_part.hpp"
#include "solution_structures/structure.hpp"

namespace rfm {

// Conditions on derivatives of first order. All data are for the *outward* normal n, as in problem
// files, while D(ω, ·) is along the inward one: signs change here and nowhere else. ω is normalised
// to first order. `value` is what u is on the part: an undetermined Ψ1, or a structure that
// satisfies other conditions already.
//
// One idea makes them all: with a condition B u = c of first order, u = P − ω (B P − c)/σ satisfies
// it where ω = 0, σ being B ω there; for n it is −1.

/// ∂u/∂n = slope: P = Ψ1 − ω D(ω, Ψ1) − ω slope, exponent 2; with ω² Ψ2 added (7.13) of Shapiro
/// (2007). For a flux k ∂u/∂n divide by k.
ConditionPart normal_derivative_part(const Structure& value, const Field& omega, const Field& slope,
                                     int dimension);

/// a u + b ∂u/∂n = c with functions a, b ≠ 0 and c: P = Ψ1 − ω D(ω, Ψ1) + ω (a Ψ1 − c)/b, exponent
/// 2; (7.14) with h₀ = −a/b and ψ₀ = −c/b. Convection to `ambient` is a = coefficient, b = k,
/// c = coefficient · ambient.
ConditionPart robin_part(const Structure& value, const Field& omega, const Field& a, const Field& b,
                         const Field& c, int dimension);

/// a u + l·∇u = c along any direction l(x) that is nowhere tangential to the part (a flux through
/// an anisotropic body has l = K n): P = Ψ1 − ω s (a Ψ1 + l·∇Ψ1 − c), exponent 2, where
/// s = (l·∇ω)/((l·∇ω)² + |l|² ω²/L²) is 1/(l·∇ω) on the part and bounded inside, where l·∇ω may
/// vanish. L is a length of the order of the domain's.
ConditionPart oblique_part(const Structure& value, const Field& omega,
                           const std::vector<Field>& direction, const Field& a, const Field& c,
                           double length = 1);

/// u = Ψ1 − ω D(ω, Ψ1) − ω slope + ω² Ψ2, eq. (7.13). Complete: every u with ∂u/∂n = slope is of
/// this form. Ψ1 alone is not: next to the boundary its second normal derivative is tied to the
/// first terms. Ψ2 is needed near the boundary only, and splines elsewhere make systems singular.
Structure neumann(const Field& omega, const Field& slope, int dimension,
                  const Structure& psi1 = Structure::undetermined(0),
                  const Structure& psi2 = Structure::undetermined(1));

/// a u + b ∂u/∂n = c on the whole boundary.
Structure robin(const Field& omega, const Field& a, const Field& b, const Field& c, int dimension,
                const Structure& psi1 = Structure::undetermined(0),
                const Structure& psi2 = Structure::undetermined(1));

}  // namespace rfm
