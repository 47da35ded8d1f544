#pragma once

#include "core/field.hpp"
#include "solution_structures/structure.hpp"

namespace rfm {

// Interfaces ω = 0 within the domain, ω normalised; "+" is where ω > 0. |ω| has a kink there, so
// that rules have to be split at the interface (as `interfaces` of `make_domain_rule` are).

/// Ψ1 + |ω| Ψ2: continuous, with a slope that jumps freely; fluxes are then natural. Without the
/// second term no smooth basis follows a jump of the coefficient: H1 order ½.
Structure kinked(const Field& omega, const Structure& psi1 = Structure::undetermined(0),
                 const Structure& psi2 = Structure::undetermined(1));

/// [u] = u₊ − u₋ = jump and k₊ ∂₊u − k₋ ∂₋u = flux_jump along ∇ω, for any Ψ:
///
///     u = Ψ1 + |ω| ((k₋ − k₊) D(ω, Ψ1) + flux_jump)/(k₊ + k₋) + jump* H(ω) + ω² Ψ2 + ω |ω| Ψ3.
///
/// k₊ and k₋ are fields on both sides; jump* is the normalizer of `jump`.
struct InterfaceData {
  Field positive_coefficient = 1.0;  ///< k₊
  Field negative_coefficient = 1.0;  ///< k₋
  Field jump = 0.0;
  Field flux_jump = 0.0;
};
Structure interface_structure(const Field& omega, const InterfaceData& data, int dimension,
                              const Structure& psi1 = Structure::undetermined(0),
                              const Structure& psi2 = Structure::undetermined(1),
                              const Structure& psi3 = Structure::undetermined(2));

}  // namespace rfm
