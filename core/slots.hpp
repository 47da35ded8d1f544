#pragma once

#include <vector>

#include "core/field.hpp"

namespace rfm {

/// A derivative that is not zero everywhere, as an expression.
struct SlotSlope {
  int slot;  ///< by its place in the list
  Field value;
};
struct SlotCurvature {
  int row, column;  ///< row ≤ column
  Field value;
};

/// The first and second derivatives of a function by its slots.
struct SlotDerivatives {
  std::vector<SlotSlope> gradient;
  std::vector<SlotCurvature> hessian;  ///< the upper triangle, row by row
};

/// Derivatives of integrands W(x, d(u)) by up to a few dozen slots, where the slots d(u) are u, its
/// gradient and Hessian, of several components: more variables than jets have. So W is
/// differentiated node by node, and its derivatives are expressions that share its nodes. They are
/// the roots of one tape of order 0 or go on into larger formulas; every slot costs what depends on
/// it, and zeros (which are left out) and constants are known before anything is evaluated. Where W
/// is not defined a derivative may be a number, as `GraphDerivative::where_defined` says: who takes
/// derivatives looks at W, too.
///
///     const Field ux = further_coordinate(4), uy = further_coordinate(5);
///     const auto [gradient, hessian] = slot_derivatives(sqrt(1 + ux * ux + uy * uy), {ux, uy});
///
/// Slots are different coordinates or parameters, else `InvalidArgument` is thrown.
SlotDerivatives slot_derivatives(const Field& function, const std::vector<Field>& slots);

/// The same derivatives of a function, but for the second ones.
std::vector<SlotSlope> slot_gradient(const Field& function, const std::vector<Field>& slots);

}  // namespace rfm
