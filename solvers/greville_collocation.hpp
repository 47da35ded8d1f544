#pragma once

#include "core/region.hpp"
#include "solvers/collocation.hpp"

namespace rfm {

/// Collocation at Greville points, the means of the inner knots of splines (core/grid_splines.hpp):
/// splines whose point lies in the region are the unknowns, and the equation holds at their points;
/// the others are attached to them (basis/web_extension.hpp), as K. Apprich, K. Höllig, J. Hörner
/// and U. Reif have it (Collocation with WEB-splines, Adv. Comput. Math. 42, 2016). So there is one
/// equation for every unknown, and one factorisation with pivots, unless values or fluxes on the
/// boundary are residuals, too: then it is least squares, by Q R.
///
/// For equations of second order errors in L2 and H1 are O(h^p) for even degrees p and O(h^(p − 1))
/// for odd ones, in L2 one or two orders below Gauss points, for a third of their cost or less (F.
/// Auricchio, L. Beirão da Veiga, T. J. R. Hughes, A. Reali, G. Sangalli, Isogeometric collocation
/// methods, 2010).
///
/// Residual k of the volume is collocated at the points of space k where there are as many spaces
/// as residuals, else all are at those of the first. Cells may have any
/// widths. Throws `ComputationError` as `solve_collocation` does.
NewtonSolution solve_greville(std::span<const Structure> structures,
                              std::span<const TensorProductSpace> spaces,
                              std::span<const Form> forms, const RegionEvaluator& region,
                              const DomainRule& rule, const NewtonOptions& options = {});

}  // namespace rfm
