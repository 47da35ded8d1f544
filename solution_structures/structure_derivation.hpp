#pragma once

#include <optional>
#include <variant>
#include <vector>

#include "core/field.hpp"
#include "solution_structures/normal_conditions.hpp"
#include "solution_structures/plate_conditions.hpp"
#include "solution_structures/structure.hpp"

namespace rfm {

// Conditions on an unknown with one component, on parts of the boundary; n is the outward normal.

/// u = value.
struct ValueCondition {
  Field value;
};
/// ∂u/∂n = slope; conditions with more data are `RobinData`, `ObliqueData`, `SupportData`.
struct SlopeCondition {
  Field slope;
};
/// u = deflection, ∂u/∂n = rotation.
struct ClampedCondition {
  Field deflection, rotation;
};
/// A condition and the part of the boundary where it holds: `omega` is zero there, positive
/// elsewhere, and normalised (`BoundaryPiece::from_inside`, levelled
/// off at the size of the domain: function_shaping.hpp).
struct StructureCondition {
  std::variant<ValueCondition, SlopeCondition, RobinData, ObliqueData, ClampedCondition,
               SupportData>
      condition;
  Field omega;
};

struct DerivationOptions {
  int dimension = 2;
  /// What multiplies the last Ψ, in the place of the product of all functions.
  std::optional<Field> remainder{};
  /// How far corrections for derivatives reach (`cutoff`), one to one and a half cells. Without it
  /// everything is joined by (7.12).
  std::optional<double> reach{};
};

/// The structure that satisfies all conditions, found from them alone by (7.12) of Shapiro (2007):
/// each gives an expression P and an exponent (condition_part.hpp), and
///
///     u = Σ Pᵢ ωᵢ^−μᵢ / Σ ωᵢ^−μᵢ + Ψ Π ωᵢ^μᵢ .
///
/// Where the value is not prescribed, P is made of Ψ1, the same for all such parts; each supported
/// edge has a Ψ for its slope; the last Ψ is that of the remainder. Values that are the same
/// field are one part, so that no quotient stands between them. Parts without condition are simply
/// not named, as are those where a natural condition is left to the energy. Without any condition
/// u = Ψ1. At points where parts meet the quotients are 0/0, and data that do not agree there
/// cannot be interpolated continuously.
///
/// With `reach`, and values and conditions of first order only, derivatives are corrections of a
/// Dirichlet structure next to the boundary instead (`corrected`): more accurate, and the last Ψ
/// needs splines within 2.2 reach of the parts with derivatives only.
Structure derived_structure(const std::vector<StructureCondition>& conditions,
                            const DerivationOptions& options = {});

}  // namespace rfm
