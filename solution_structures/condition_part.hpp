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

/// A condition of first order as a correction of what does not satisfy it.
struct NaturalPart {
  /// By how much ∂w/∂ν is too large (normal_conditions.hpp).
  Structure excess;
  Field omega;
  /// Multiplies the correction: 1 where ω = 0, with no slope there; see `corrected`.
  Field cutoff = 1.0;
};

/// What is zero where a structure takes prescribed values.
struct PrescribedValues {
  Field omega;  ///< multiplies what is added to u
  /// How far that is, to first order: weighs corrections against their ω. A product of several
  /// such functions would be far too small.
  Field distance;
};

/// Conditions of first order on top of a structure w, without quotients between data. Our own form:
///
///     u = w − Σᵢ χᵢ ωᵢ d²/(d² + ωᵢ²) Rᵢ(w) + Ψ ω₀ Σᵢ χᵢ ωᵢ² ,
///
/// where w takes the prescribed values on ω₀ = d = 0 (a Dirichlet structure; without `values`, Ψ1
/// itself and d = ∞), Rᵢ is the excess, and of several parts χᵢ stands for χᵢ Π ωⱼ²/(ωⱼ² + ωᵢ²).
/// Where boundaries meet shares are homogeneous of degree 0, so that slopes of u are bounded, and
/// rules have to be graded. (With ω₀/(ω₀ + ωᵢ²) slopes were like 1/r there, in layers of width r².)
///
/// With χ = exp(−(ω/w)⁴) (`cutoff` of core/function_shaping.hpp), w from one to one and a half
/// cells, corrections stay near the boundary, and Ψ needs no splines further away than 2.2 w. This
/// is better than χ = 1: of order p in H1 for splines of degree p where Ψ1 − ω D(ω, Ψ1) alone has
/// p − 1, with a system whose smallest eigenvalue is 10⁻³ and not 0 as that of Ψ1 and ω² Ψ2
/// everywhere (`tests/solvers/completeness_test.cpp`).
Structure corrected(const Structure& w, const std::vector<NaturalPart>& natural,
                    const Structure& psi, const std::optional<PrescribedValues>& values = {});

}  // namespace rfm
