#pragma once

#include <vector>

#include "core/field.hpp"

namespace rfm {

// Derivatives as fields, beside those of core/field.hpp. All are exact: the tape that evaluates
// them asks its arguments for jets of higher order.

/// ∂²f/∂xᵢ∂xⱼ, row by row: dimension² fields, of which equal ones are shared.
std::vector<Field> hessian(const Field& f, int dimension);
/// Σᵢ ∂vᵢ/∂xᵢ over as many coordinates as `v` has components.
Field divergence(const std::vector<Field>& v);
/// D_v^m f along the *straight* line in direction v(x), which is held: the m-jet of f contracted
/// with v m times, Σ_{|α|=m} m!/α! v^α ∂^α f. This is the D_ν^m of normalisation (Shapiro 2007,
/// (4.8)) and of moments of plates. `v` has as many components as there are coordinates.
Field directional_derivative(const Field& f, const std::vector<Field>& v, int order);
/// (v·∇)^m f: the first derivative taken m times, which differentiates v too. Another operator than
/// `directional_derivative` from m = 2 on, unless v is constant along itself.
Field iterated_directional_derivative(const Field& f, const std::vector<Field>& v, int order);

/// Normalisation to order 1 to 4: zero where f is, with D_ν = 1 and D_ν^k = 0, k = 2 … order, along
/// the inward normal at regular points of {f = 0}. Order 1 is (4.9) of Shapiro (2007),
/// ω₁ = f / √(f² + |∇f|²). Order 2 is its recursion (4.10), ω₁ − ½ ω₁² D_ν² ω₁ with the frozen
/// ν = ∇ω₁. For higher orders the recursion
///
///     ω_k = ω_{k−1} − (1/k!) ω₁^k D_ν^k ω_{k−1}
///
/// is carried out on the Taylor polynomial of ω₁ along its frozen gradient, so that jets of order
/// m + 1 suffice where the recursion itself would need m(m+1)/2. ∇ω₁ is turned from the normal by
/// O(ω²) only, which changes distances by O(ω⁵): hence no more than order 4. Nothing is divided by
/// |∇ω₁|, which vanishes inside. All of it happens in lengths of `length`, which may be infinite
/// (`normalize_within`): with that of a shape or domain the result does not depend on the unit.
/// Throws `InvalidArgument` on another order, or a length that is not positive.
Field normalize(const Field& f, int dimension, int order, double length = 1);

}  // namespace rfm
