#pragma once

#include <optional>
#include <vector>

#include "core/field.hpp"
#include "solution_structures/structure.hpp"

namespace rfm {

/// What one boundary condition gives to a structure: an expression P that satisfies it where ω = 0,
/// whatever the Ψ in it are, and that every u which satisfies it equals up to O(ω^exponent) for
/// some Ψ: a generalised Taylor polynomial (Shapiro 2007, §7.1). The exponent is the order of the
/// highest derivative that is prescribed, plus one.
struct ConditionPart {
  Structure polynomial;
  Field omega;  ///< zero on the part of the boundary, positive elsewhere, normalised
  int exponent = 1;
};

/// Σ Pᵢ Wᵢ with the weights of (7.10), Wᵢ = ωᵢ^−μᵢ / Σ ωⱼ^−μⱼ, μᵢ the exponents: it satisfies every
/// condition. 0/0 where two of the ωᵢ vanish; a single P stays itself. Written
/// `transfinite(p1, omega1, mu1, …)`. Throws `InvalidArgument` for none.
Structure transfinite(const std::vector<ConditionPart>& parts);

/// Π ωᵢ^μᵢ: with it may be multiplied what is added to a structure.
Field remainder_factor(const std::vector<ConditionPart>& parts);

/// The general structure for any number of conditions of any kind, eq. (7.12) of Shapiro (2007)
/// with exponents kᵢ + 1:
///
///     u = Σ Pᵢ Wᵢ + Ψ Π ωᵢ^μᵢ .
///
/// Its case of two parts is (7.15). Complete by theorem 9 where the parts do not meet, also if all
/// P use the same Ψ. `factor` stands for the product if it is given: behaviour that is known
/// beforehand (§7.3); conditions hold if it vanishes as the product does.
Structure mixed(const std::vector<ConditionPart>& parts, const Structure& psi,
                const std::optional<Field>& factor = {});

/// Values and natural conditions without quotients between them, our own form:
///
///     u = w − Σᵢ ω₀ ωᵢ / (ω₀ + ωᵢ²) Rᵢ(w) + Ψ ω₀ Π ωᵢ²,
///
/// where w takes the values on ω₀ = 0 (a Dirichlet structure) and Rᵢ(w) is by how much ∂w/∂νᵢ is
/// too large. The factor is ωᵢ + O(ωᵢ³) next to part i and zero on ω₀ = 0. Of several natural parts
/// the others' functions multiply it as ωⱼ²/(ωⱼ² + ωᵢ²).
struct NaturalPart {
  Structure excess;  ///< R(w)
  Field omega;
};
Structure corrected_values(const Structure& w, const Field& omega,
                           const std::vector<NaturalPart>& natural, const Structure& psi);

}  // namespace rfm
