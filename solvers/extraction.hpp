#pragma once

#include <vector>

#include "solvers/linear_system.hpp"

namespace rfm {

/// Functions that are combinations of the splines of some spaces, as extended or periodic ones are:
/// c = E y, c the coefficients of all splines, block by block, and y theirs.
struct SplineExtraction {
  SparseMatrix matrix;  ///< E
  /// Of each column a spline whose coefficient it is: y = c there.
  std::vector<Eigen::Index> inner;

  /// Eᵀ K E y = Eᵀ f: the same equations for the combinations.
  LinearSystem folded(const LinearSystem& system) const;
  /// y of coefficients c = E y. By columns.
  Eigen::MatrixXd reduced(const Eigen::MatrixXd& coefficients) const;
};

}  // namespace rfm
