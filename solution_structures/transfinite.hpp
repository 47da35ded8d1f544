#pragma once

#include <vector>

#include "core/field.hpp"

namespace rfm {

/// Data on one of several sets: `value` is taken where `distance` = 0. `distance` ≥ 0 is normalised
/// (or any function that vanishes on the set to first order), `exponent` is μ.
struct TransfiniteDatum {
  Field value;
  Field distance;
  int exponent = 1;
};

/// Transfinite interpolation by inverse distances,
///
///     Σ_i g_i W_i ,   W_i = ω_i^{−μ_i} / Σ_j ω_j^{−μ_j}
///                         = Π_{j≠i} ω_j^{μ_j} / Σ_k Π_{j≠k} ω_j^{μ_j} ,
///
/// eq. (7.10) of Shapiro (2007), in the second form, which is finite on the sets. It equals g_i
/// where ω_i = 0 alone, with all derivatives up to order μ_i − 1 of g_i. Where several sets meet,
/// data that disagree make it discontinuous there, and at the very point it is 0/0 (evaluated as
/// NaN). Sets that share a value (the same field) should be one datum.
/// Throws `InvalidArgument` for no data.
Field transfinite_interpolant(const std::vector<TransfiniteDatum>& data);
/// The W_i alone. The values of the data are not looked at.
std::vector<Field> transfinite_weights(const std::vector<TransfiniteDatum>& data);

}  // namespace rfm
