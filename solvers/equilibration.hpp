#pragma once

#include <Eigen/Core>

#include "solvers/linear_system.hpp"

namespace rfm {

/// Factors of rows and columns of a square matrix that need not be symmetric, by which R A C has
/// largest entries of about 1 in every row and column: for splines that touch the region by a
/// sliver and for unknowns of different units, what the square root of the diagonal is for
/// symmetric matrices. Source: D. Ruiz, A scaling algorithm to equilibrate both rows and columns
/// norms in matrices (2001); a few sweeps, each taking the square roots of the largest entries out.
/// For a symmetric matrix R = C.
struct Equilibration {
  /// 0 where a row or a column has no entry above 10⁻³⁰⁰: such functions are dropped.
  Eigen::VectorXd rows, columns;
  int dropped = 0;

  explicit Equilibration(const SparseMatrix& matrix);
  /// R A C, with a unit row for every function that was dropped.
  SparseMatrix apply(const SparseMatrix& matrix) const;
};

}  // namespace rfm
