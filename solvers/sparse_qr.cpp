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

double smallest_singular_value(const cholmod_sparse& r) {
  const auto size = static_cast<Eigen::Index>(r.ncol);
  const Eigen::Map<const SparseMatrix> upper(
      size, size, static_cast<const std::int64_t*>(r.p)[size],
      static_cast<const std::int64_t*>(r.p), static_cast<const std::int64_t*>(r.i),
      static_cast<const double*>(r.x));
  // Alternating signs have a share of what oscillates, as the smallest ones do.
  Eigen::VectorXd vector(size);
  for (Eigen::Index i = 0; i < size; ++i) vector[i] = i % 2 == 0 ? 1 : -0.7;
  double value = 0;
  for (int step = 0; step < 2; ++step) {
    vector.normalize();
    const Eigen::VectorXd half =
        upper.transpose().triangularView<Eigen::Lower>().solve(vector).eval();
    vector = upper.triangularView<Eigen::Upper>().solve(half).eval();
    value = half.norm() / vector.norm();
  }
  return value;
}

}  // namespace

LeastSquaresSolution least_squares_solution(const SparseMatrix& matrix,
                                            const Eigen::VectorXd& load) {
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
  // X = E R⁻¹ Qᵀ b and R, whose columns E permutes.
  constexpr int get_x = 2;
  cholmod_dense* x = nullptr;
  cholmod_sparse* r = nullptr;
  SuiteSparse_long* permutation = nullptr;
  const SuiteSparse_long rank = SuiteSparseQR_C(
      SPQR_ORDERING_DEFAULT, SPQR_DEFAULT_TOL, static_cast<SuiteSparse_long>(scaled.cols()), get_x,
      &a, nullptr, &b, nullptr, &x, &r, &permutation, nullptr, nullptr, nullptr, &cholmod.common);
  LeastSquaresSolution result;
  if (rank == scaled.cols() && x != nullptr && r != nullptr) {
    result.solution = factors.cwiseProduct(Eigen::Map<const Eigen::VectorXd>(
        static_cast<const double*>(x->x), static_cast<Eigen::Index>(x->nrow)));
    result.smallest_singular_value = smallest_singular_value(*r);
  }
  cholmod_l_free(static_cast<std::size_t>(scaled.cols()), sizeof(SuiteSparse_long), permutation,
                 &cholmod.common);
  cholmod_l_free_sparse(&r, &cholmod.common);
  cholmod_l_free_dense(&x, &cholmod.common);
  if (rank < 0)
    throw ComputationError("not enough memory for least squares of " +
                           std::to_string(scaled.cols()) + " unknowns");
  if (rank < scaled.cols()) throw SingularSystem();
  return result;
}

}  // namespace rfm
