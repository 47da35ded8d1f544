#include "solvers/equilibration.hpp"

#include <cmath>

#include "core/error.hpp"

namespace rfm {
namespace {

constexpr double smallest_entry = 1e-300;
constexpr int sweeps = 8;

}  // namespace

Equilibration::Equilibration(const SparseMatrix& matrix)
    : rows(Eigen::VectorXd::Ones(matrix.rows())), columns(Eigen::VectorXd::Ones(matrix.cols())) {
  Eigen::VectorXd in_row(matrix.rows()), in_column(matrix.cols());
  for (int sweep = 0; sweep < sweeps; ++sweep) {
    in_row.setZero();
    in_column.setZero();
    for (Eigen::Index column = 0; column < matrix.outerSize(); ++column)
      for (SparseMatrix::InnerIterator entry(matrix, column); entry; ++entry) {
        if (!std::isfinite(entry.value()))
          throw ComputationError("the system of equations contains a number that is not finite");
        // One factor at a time: the product of two may overflow.
        const double size = std::abs(entry.value()) * rows[entry.row()] * columns[column];
        in_row[entry.row()] = std::max(in_row[entry.row()], size);
        in_column[column] = std::max(in_column[column], size);
      }
    for (Eigen::Index i = 0; i < rows.size(); ++i) {
      if (sweep == 0 && (in_row[i] < smallest_entry || in_column[i] < smallest_entry)) {
        rows[i] = columns[i] = 0;
        ++dropped;
      }
      if (in_row[i] > 0) rows[i] /= std::sqrt(in_row[i]);
      if (in_column[i] > 0) columns[i] /= std::sqrt(in_column[i]);
    }
  }
}

SparseMatrix Equilibration::apply(const SparseMatrix& matrix) const {
  SparseMatrix scaled = matrix;
  for (Eigen::Index column = 0; column < scaled.outerSize(); ++column)
    for (SparseMatrix::InnerIterator entry(scaled, column); entry; ++entry) {
      entry.valueRef() = (entry.value() * rows[entry.row()]) * columns[column];
      if (entry.row() == column && rows[column] == 0) entry.valueRef() = 1;
    }
  return scaled;
}

}  // namespace rfm
