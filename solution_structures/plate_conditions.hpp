#pragma once

#include "core/field.hpp"
#include "solution_structures/condition_part.hpp"
#include "solution_structures/structure.hpp"

namespace rfm {

// Conditions of equations of fourth order: the bending w of plates. Data are for the outward
// normal n; ω is normalised to first order.

/// w = deflection and ∂w/∂n = rotation: P = g* − ω rotation, exponent 2. g* is the normalizer
/// g(x − ω∇ω) of the deflection (7.2): g itself has a normal derivative of its own.
ConditionPart clamped_part(const Field& omega, const Field& deflection, const Field& rotation,
                           int dimension);
/// w = g* − ω rotation + ω² Ψ. Complete in H².
Structure clamped(const Field& omega, const Field& deflection, const Field& rotation, int dimension,
                  const Structure& psi = Structure::undetermined(0));

/// D_ν² u = Σ ∂ᵢω ∂ⱼω ∂ᵢ∂ⱼu: the second derivative along the *straight* normal. D(ω, D(ω, u))
/// differentiates ∇ω as well and is another operator.
Structure second_normal_derivative(const Structure& u, const Field& omega, int dimension);
Field second_normal_derivative(const Field& u, const Field& omega, int dimension);

/// −(∂²w/∂n² + ν (Δw − ∂²w/∂n²)): the bending moment on the boundary for unit rigidity.
Structure normal_moment(const Structure& w, const Field& omega, const Field& poisson_ratio,
                        int dimension);
Field normal_moment(const Field& w, const Field& omega, const Field& poisson_ratio, int dimension);

/// ∂²u/∂n² = curvature beside what `value` satisfies already: P = V − ½ ω² (D_ν² V − curvature),
/// exponent 3.
ConditionPart second_derivative_part(const Structure& value, const Field& omega,
                                     const Field& curvature, int dimension);
/// w = deflection and moment M_n = moment (divided by the rigidity), on a curved edge too: with
/// V = g + ω Ψ1, P = V + ½ χ ω² (M_n(V) − moment), exponent 3. The cutoff χ keeps the correction
/// near the edge (as in `corrected`). Where moments are natural, as in the energy of a plate, the
/// Dirichlet structure is enough.
struct SupportData {
  Field deflection, moment;
  Field poisson_ratio = 0.3;
  Field cutoff = 1.0;
};
ConditionPart simply_supported_part(const Field& omega, const SupportData& data, int dimension,
                                    const Structure& psi = Structure::undetermined(0));
/// P + χ ω³ Ψ2, the whole edge supported.
Structure simply_supported(const Field& omega, const SupportData& data, int dimension);

}  // namespace rfm
