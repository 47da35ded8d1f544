#include "solvers/extraction.hpp"

#include <Eigen/SparseCholesky>

#include "core/error.hpp"

namespace rfm {

LinearSystem SplineExtraction::folded(const LinearSystem& system) const {
  LinearSystem result;
  result.symmetric = system.symmetric;
  result.constant = system.constant;
  const SparseMatrix transposed = matrix.transpose();
  result.right_hand_side = transposed * system.right_hand_side;
  const SparseMatrix whole = system.symmetric
                                 ? SparseMatrix(system.matrix.selfadjointView<Eigen::Lower>())
                                 : system.matrix;
  const SparseMatrix product = transposed * SparseMatrix(whole * matrix);
  result.matrix = system.symmetric ? SparseMatrix(product.triangularView<Eigen::Lower>()) : product;
  return result;
}

Eigen::MatrixXd SplineExtraction::reduced(const Eigen::MatrixXd& coefficients) const {
  if (inner.empty()) {
    const SparseMatrix transposed = matrix.transpose();
    const Eigen::SimplicialLDLT<SparseMatrix> squares(SparseMatrix(transposed * matrix));
    if (squares.info() != Eigen::Success)
      throw ComputationError("combinations of splines depend on each other");
    const Eigen::MatrixXd first = squares.solve(transposed * coefficients);
    return first + squares.solve(transposed * (coefficients - matrix * first));
  }
  Eigen::MatrixXd rows(static_cast<Eigen::Index>(inner.size()), coefficients.cols());
  for (std::size_t i = 0; i < inner.size(); ++i)
    rows.row(static_cast<Eigen::Index>(i)) = coefficients.row(inner[i]);
  return rows;
}

}  // namespace rfm
