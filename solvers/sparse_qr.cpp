#include "solvers/sparse_qr.hpp"

#include <SuiteSparseQR_C.h>
#include <fmt/format.h>

#include "core/error.hpp"
#include "solvers/blas_threads.hpp"
#include "solvers/symmetric_factorization.hpp"

namespace rfm {
namespace {

class Cholmod {
 public:
  Cholmod() {
    use_one_thread_in_blas();
    cholmod_l_start(&common);
    common.print = 0;
  }
  ~Cholmod() { cholmod_l_finish(&common); }
  cholmod_common common{};
};

}  // namespace

Eigen::VectorXd least_squares_solution(const SparseMatrix& matrix, const Eigen::VectorXd& load) {
  if (matrix.rows() < matrix.cols())
    throw ComputationError(
        fmt::format("there are {} equations for {} unknowns", matrix.rows(), matrix.cols()));
  SparseMatrix scaled = matrix;
  Eigen::VectorXd factors(matrix.cols());
  for (Eigen::Index column = 0; column < scaled.outerSize(); ++column) {
    const double length = matrix.col(column).norm();
    factors[column] = length > 0 ? 1 / length : 0;
    for (SparseMatrix::InnerIterator entry(scaled, column); entry; ++entry)
      entry.valueRef() *= factors[column];
  }
  if (!factors.allFinite() || !scaled.coeffs().allFinite() || !load.allFinite())
    throw ComputationError("the system of equations contains a number that is not finite");
  Cholmod cholmod;
  cholmod_sparse a{};
  a.nrow = static_cast<std::size_t>(scaled.rows());
  a.ncol = static_cast<std::size_t>(scaled.cols());
  a.nzmax = static_cast<std::size_t>(scaled.nonZeros());
  a.p = scaled.outerIndexPtr();
  a.i = scaled.innerIndexPtr();
  a.x = scaled.valuePtr();
  a.itype = CHOLMOD_LONG;
  a.xtype = CHOLMOD_REAL;
  a.dtype = CHOLMOD_DOUBLE;
  a.sorted = a.packed = 1;
  cholmod_dense b{};
  b.nrow = b.d = b.nzmax = static_cast<std::size_t>(load.size());
  b.ncol = 1;
  b.x = const_cast<double*>(load.data());
  b.xtype = CHOLMOD_REAL;
  b.dtype = CHOLMOD_DOUBLE;
  cholmod_dense* result = SuiteSparseQR_C_backslash_default(&a, &b, &cholmod.common);
  if (result == nullptr)
    throw ComputationError("not enough memory for least squares of " +
                           std::to_string(scaled.cols()) + " unknowns");
  const Eigen::VectorXd solution = Eigen::Map<const Eigen::VectorXd>(
      static_cast<const double*>(result->x), static_cast<Eigen::Index>(result->nrow));
  cholmod_l_free_dense(&result, &cholmod.common);
  constexpr int rank_place = 4;
  if (cholmod.common.SPQR_istat[rank_place] < scaled.cols()) throw_singular();
  return factors.cwiseProduct(solution);
}

}  // namespace rfm
