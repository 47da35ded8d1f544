#pragma once

#include <Eigen/SparseCore>
#include <cstdint>
#include <vector>

namespace rfm {

/// A matrix by columns (of a symmetric one, its lower triangle), with the long indices of CHOLMOD:
/// factors of some hundred thousand unknowns exceed the range of 32 bits.
using SparseMatrix = Eigen::SparseMatrix<double, Eigen::ColMajor, std::int64_t>;

/// The quadratic function E(c) = ½ cᵀ K c − fᵀ c + constant of the coefficients c of all
/// undetermined functions, block by block in the order of the functions. Its stationary point
/// solves K c = f. Weak forms that follow from no energy have equations K c = f alone.
struct LinearSystem {
  SparseMatrix matrix;    ///< K: the lower triangle if symmetric, else all of it
  bool symmetric = true;  ///< else there is no energy
  Eigen::VectorXd right_hand_side;
  double constant = 0;
  /// A good order of elimination, if one is known (nested_dissection.hpp).
  std::vector<std::int64_t> elimination_order{};

  Eigen::Index size() const { return right_hand_side.size(); }
  double energy(const Eigen::VectorXd& coefficients) const {
    const Eigen::VectorXd product = matrix.selfadjointView<Eigen::Lower>() * coefficients;
    return (0.5 * product - right_hand_side).dot(coefficients) + constant;
  }
};

}  // namespace rfm
