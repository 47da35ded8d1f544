#pragma once

#include <vector>

#include "core/field.hpp"
#include "solvers/form.hpp"

namespace rfm {

/// J. Nitsche's method (1971) for u_c = g on a part of the boundary, for any form in the volume
/// with first derivatives of the unknown: with the flux q(u) = Σ F_{∂i v_c} n_i, which the form
/// itself tells, and k = Σ ∂q_i/∂(∂_j u_c) n_i n_j,
///
///     −q(u) v − (∂q/∂d(u) · d(v)) (u_c − g) + penalty k (u_c − g) v,
///
/// with |b·n|₋ (u_c − g) v beside it in weak forms with b·∇u_c v, so that values hold on the inflow
/// however small k is (b that stands at the derivatives of v is not covered);
/// the derivative of −q (u_c − g) + ½ penalty k (u_c − g)², but for that of k, where the volume has
/// an energy.
/// Consistent, so of full order, also for nonlinear fluxes. There k and ∂q/∂d are held
/// (solvers/form_symbols.hpp): the tangent leaves out their changes, which are multiplied by
/// u_c − g and would make it indefinite far from the data, so that Newton's method converges at a
/// rate of about the relative error of the solution instead of quadratically. `normal` is the
/// outward unit normal as fields; the penalty is p²/h times a number (problems use 20). Throws
/// `InvalidArgument` where the form has derivatives above the first, or none of this unknown, and
/// for least squares, which take values as residuals.
Form weak_values(const Form& volume, int component, const Field& g,
                 const std::vector<Field>& normal, double penalty, FormPlace place);

}  // namespace rfm
