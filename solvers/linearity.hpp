#pragma once

#include <span>

#include "quadrature/domain_rule.hpp"
#include "solvers/form.hpp"
#include "solvers/linear_system.hpp"

namespace rfm {

/// How equations are known to be linear, so that one system is the solution.
enum class Linearity {
  by_form,   ///< the formulas of the tangents have no unknowns
  by_value,  ///< they have, but at random points and states nothing changes: u² − u·u
  none
};

/// Whether a form whose formula has unknowns in its tangent is linear all the same: at points of
/// its place in `rule` the tangent C(x, d) is the same for random values d of the slots, of sizes
/// from 1e-3 to 1e2, and F(x, d) = F(x, 0) + C d, to nine digits. Many points and states are no
/// proof: what differs elsewhere, or jumps only far away, is found by `departure_from_linear` at
/// the solution. False where a value is not a number, as at d = 0 in u²/u.
bool is_linear_by_value(const Form& form, const DomainRule& rule);

/// Of all forms of a problem.
Linearity linearity(std::span<const Form> forms, const DomainRule& rule);

/// The equations K c = f of a problem that is thought to be linear against its residual R(c),
/// assembled at a solution c: the norm of R(c) − (f − K c) relative to those of f and K c, rows
/// scaled by those of K. Rounding if the problem is linear where c is.
double departure_from_linear(const LinearSystem& system, const Eigen::VectorXd& coefficients,
                             const Eigen::VectorXd& residual);
/// Whether that is rounding.
bool is_linear_at(const LinearSystem& system, const Eigen::VectorXd& coefficients,
                  const Eigen::VectorXd& residual);

}  // namespace rfm
