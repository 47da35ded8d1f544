#pragma once

#include <vector>

#include "solvers/linear_system.hpp"

namespace rfm {

/// Functions that are combinations of the splines of some spaces, as extended, periodic or coarser
/// ones are: c = E y, c the coefficients of all splines, block by block, and y theirs.
struct SplineExtraction {
  SparseMatrix matrix;  ///< E
  /// Of each column a spline whose coefficient it is: y = c there. Empty where there are none.
  std::vector<Eigen::Index> inner;
  /// The first combination of each function, and their number.
  std::vector<Eigen::Index> first{0};

  /// Eᵀ K E y = Eᵀ f: the same equations for the combinations.
  LinearSystem folded(const LinearSystem& system) const;
  /// y of coefficients c = E y, where needed by least squares. By columns.
  Eigen::MatrixXd reduced(const Eigen::MatrixXd& coefficients) const;
};

}  // namespace rfm
