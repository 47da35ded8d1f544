#pragma once

#include <functional>
#include <span>
#include <vector>

#include "basis/tensor_product_space.hpp"
#include "quadrature/domain_rule.hpp"
#include "solution_structures/structure.hpp"
#include "solvers/form.hpp"
#include "solvers/newton.hpp"

namespace rfm {

/// The residuals of a form at the points of a rule, as functions of the coefficients of a change of
/// the solution: right_hand_side − matrix · change, with one row for each residual and point, times
/// the root of the weight of the point.
struct CollocationSystem {
  SparseMatrix matrix;
  Eigen::VectorXd right_hand_side;
};

/// Points by cell: those of cell c are begin[c] … begin[c + 1] − 1.
struct CollocationPoints {
  VolumePoints points;
  std::vector<int> begin;
};

/// Residuals of `forms` (least squares, others are refused with `InvalidArgument`) and their
/// derivatives where the solution is `components`; `changes` are structures without inhomogeneous
/// part. Residuals over the volume are taken at the points of the rule in cells, or those of the
/// volume's k-th residual at the points `volume[k]` (at `volume[0]` if there are no others),
/// residuals over the boundary at its boundary points.
CollocationSystem collocate(std::span<const Form> forms, std::span<const Field> components,
                            std::span<const Structure> changes,
                            std::span<const TensorProductSpace> spaces, const DomainRule& rule,
                            std::span<const CollocationPoints> volume = {});

/// Collocation: the equations hold at points, more of them than there are unknowns (Gauss points
/// of a rule with few points per cell, on the boundary too), in the sense of least squares, by a
/// Q R factorisation (solvers/sparse_qr.hpp). Nonlinear residuals by Gauss's and Newton's method,
/// as in `solve_newton`, to which `options` belong. As exact as least squares with integrals, from
/// fewer points, and conditioned as the root of their normal equations. With a rule that integrates
/// the squares it *is* least squares.
NewtonSolution solve_collocation(std::span<const Structure> structures,
                                 std::span<const TensorProductSpace> spaces,
                                 std::span<const Form> forms, const DomainRule& rule,
                                 const NewtonOptions& options = {});

/// A nonlinear least-squares problem in a vector y.
struct ResidualProblem {
  std::function<CollocationSystem(const Eigen::VectorXd&)> at;
  Eigen::Index size = 0;
  bool is_linear = false;
  /// The norm of the residuals where the whole solution is zero, of the size of the loads; 0 where
  /// it is not known. As in `NewtonEquations`, a start that is the solution is known by it.
  double load = 0;
  /// What nothing may fix, as columns: `FreeFunctions`.
  Eigen::MatrixXd candidates{};
};
/// `ResidualProblem::load` of residuals that are not linear; 0 where they have no value there, and
/// where no structure has data, so that the start is zero itself.
double residual_load(std::span<const Form> forms, std::span<const Structure> structures,
                     std::span<const TensorProductSpace> spaces, const DomainRule& rule,
                     std::span<const CollocationPoints> volume = {});
/// Gauss's and Newton's method from y = 0, each step by Q R, or by a factorisation with pivots
/// where there are as many residuals as unknowns. Linear problems have no iterations. Steps are
/// measured by what they change in the residuals, so that functions hardly seen by any point do
/// not count. Combinations of the candidates that no residual sees are held where they tell
/// themselves best, by an equation more for each, and returned as `NewtonSolution::free`.
NewtonSolution solve_residuals(const ResidualProblem& problem, const NewtonOptions& options);

}  // namespace rfm
