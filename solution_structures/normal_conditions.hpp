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
// One idea makes them all: with a condition B u = c of first order, V − ω (B V − c)/σ satisfies it
// where ω = 0, σ being B ω there; for n it is −1.
//
// Of each there is the *excess* R(V), by how much ∂V/∂ν is too large where ω = 0, and the part
// P = V − ω R(V) of exponent 2 (condition_part.hpp).

/// ∂u/∂n = slope: R = D(ω, V) + slope. P + ω² Ψ2 is (7.13) of Shapiro (2007). For a flux k ∂u/∂n
/// divide by k.
Structure normal_derivative_excess(const Structure& value, const Field& omega, const Field& slope,
                                   int dimension);
ConditionPart normal_derivative_part(const Structure& value, const Field& omega, const Field& slope,
                                     int dimension);

/// a u + b ∂u/∂n = c with functions a, b ≠ 0 and c: R = D(ω, V) − (a V − c)/b; (7.14) with
/// h₀ = −a/b and ψ₀ = −c/b. Convection to `ambient` is a = coefficient, b = k,
/// c = coefficient · ambient.
struct RobinData {
  Field a, b, c;
};
Structure robin_excess(const Structure& value, const Field& omega, const RobinData& data,
                       int dimension);
ConditionPart robin_part(const Structure& value, const Field& omega, const RobinData& data,
                         int dimension);

/// a u + l·∇u = c along any direction l(x) that is nowhere tangential to the part (a flux through
/// an anisotropic body has l = K n): R = s (a V + l·∇V − c), where
/// s = (l·∇ω)/((l·∇ω)² + |l|² ω²/L²) is 1/(l·∇ω) on the part and bounded inside, where l·∇ω may
/// vanish. L is a length of the order of the domain's.
struct ObliqueData {
  std::vector<Field> direction;
  Field a, c;
  double length = 1;
};
/// Both throw `InvalidArgument` unless L > 0.
Structure oblique_excess(const Structure& value, const Field& omega, const ObliqueData& data);
ConditionPart oblique_part(const Structure& value, const Field& omega, const ObliqueData& data);

/// u = Ψ1 − χ ω (D(ω, Ψ1) + slope) + χ ω² Ψ2; (7.13) for χ = 1. Complete: every u with ∂u/∂n =
/// slope is of this form. Ψ1 alone is complete in the limit but loses an order; of χ, and where Ψ2
/// is needed, see `corrected`.
Structure neumann(const Field& omega, const Field& slope, int dimension, const Field& cutoff = 1.0);

/// a u + b ∂u/∂n = c on the whole boundary, in the same way.
Structure robin(const Field& omega, const RobinData& data, int dimension,
                const Field& cutoff = 1.0);

}  // namespace rfm
