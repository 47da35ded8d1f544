#pragma once

#include <optional>
#include <vector>

#include "solution_structures/structure.hpp"

namespace rfm {

/// What an interpolant takes on one set: a point, a curve, a surface, a region, on a boundary or
/// not.
struct SetData {
  /// Zero on the set, positive elsewhere, normalised where derivatives are given.
  Field distance;
  /// Without it the set has derivatives only, and the value there is what the other sets give.
  std::optional<Field> value;
  /// ∂ᵏu/∂nᵏ, k = 1, 2, …, at most 4, along the straight normal n = −∇ω/|∇ω|.
  std::vector<Field> derivatives = {};
  /// ω: zero on the set, of either sign, normalised. Needed for derivatives alone.
  std::optional<Field> side = {};
  /// μ; 0 for one more than the order of the highest derivative.
  int exponent = 0;
  /// Of further sets with the same data, which are one set with this, like `distance`.
  std::vector<Field> further_distances = {};
};

/// Transfinite interpolation over any number of sets, by the weights (7.10) of Shapiro (2007) with
/// an exponent for each:
///
///     u = Σ Pᵢ dᵢ^−μᵢ / Σ dᵢ^−μᵢ ,   Pᵢ = f₀* + Σ_k f_k* ωᵢᵏ / k! ,
///
/// Pᵢ the generalised Taylor polynomials (7.5) of the data with normalizers f* (`taylor_part`), dᵢ
/// the distances, levelled off at `length` (of the order of the domain's size) and divided by it,
/// so that exponents that differ mean the same in every unit of length. The distance of several
/// sets that are one is the product of theirs. The larger μ of a set, the flatter u is next to it.
/// Of a set with a derivative alone P = F − ω (D(ω, F) + h), F the interpolant of all sets with
/// values. At points where sets meet u is 0/0, and next to such a point it takes all values between
/// theirs; equal values that meet belong to one entry.
///
/// Throws `InvalidArgument` without a value, for an exponent that is negative or no larger than the
/// order of a derivative (which would be lost), for derivatives without `side`, and for further
/// derivatives beside none or more than one order without a value.
Structure interpolated(const std::vector<SetData>& sets, double length, int dimension);

}  // namespace rfm
