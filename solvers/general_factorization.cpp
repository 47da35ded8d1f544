#include "solvers/general_factorization.hpp"

#include <umfpack.h>

#include <array>
#include <cmath>
#include <string>
#include <type_traits>

#include "core/error.hpp"
#include "solvers/blas_threads.hpp"
#include "solvers/symmetric_factorization.hpp"

namespace rfm {
namespace {

static_assert(std::is_same_v<SuiteSparse_long, std::int64_t>);

constexpr double singular_value = 1e-14;  // an exact zero comes out as some 1e-16

using Control = std::array<double, UMFPACK_CONTROL>;

Control control() {
  Control control{};
  umfpack_dl_defaults(control.data());
  control[UMFPACK_IRSTEP] = 1;
  control[UMFPACK_SCALE] = UMFPACK_SCALE_NONE;  // systems are scaled before
  return control;
}

void require_success(SuiteSparse_long status, Eigen::Index size) {
  if (status == UMFPACK_OK) return;
  if (status == UMFPACK_WARNING_singular_matrix) throw SingularSystem();
  if (status == UMFPACK_ERROR_out_of_memory)
    throw ComputationError("not enough memory to factorise a system of " + std::to_string(size) +
                           " equations");
  throw ComputationError("the factorisation of the system of equations failed (UMFPACK " +
                         std::to_string(status) + ")");
}

}  // namespace

GeneralFactorization::GeneralFactorization(const SparseMatrix& matrix) : matrix_(matrix) {
  if (matrix.rows() != matrix.cols() || !matrix.isCompressed())
    throw InvalidArgument("a factorisation needs a square, compressed matrix");
  if (matrix.nonZeros() > 0 && !matrix.coeffs().allFinite())
    throw ComputationError("the system of equations contains a number that is not finite");
  if (matrix.rows() == 0) return;
  use_one_thread_in_blas();
  const Control settings = control();
  const std::int64_t size = matrix.rows();
  void* symbolic = nullptr;
  SuiteSparse_long status =
      umfpack_dl_symbolic(size, size, matrix.outerIndexPtr(), matrix.innerIndexPtr(),
                          matrix.valuePtr(), &symbolic, settings.data(), nullptr);
  if (status == UMFPACK_OK)
    status = umfpack_dl_numeric(matrix.outerIndexPtr(), matrix.innerIndexPtr(), matrix.valuePtr(),
                                symbolic, &numeric_, settings.data(), nullptr);
  umfpack_dl_free_symbolic(&symbolic);
  try {
    require_success(status, size);
    Eigen::VectorXd vector(size);
    for (Eigen::Index i = 0; i < size; ++i) vector[i] = 1 + 0.5 * std::sin(1.7 * double(i));
    for (int step = 0; step < 2; ++step) {
      vector.normalize();
      vector = solve(UMFPACK_At, solve(UMFPACK_A, vector));
    }
    smallest_singular_value_ = 1 / std::sqrt(vector.norm());
    if (!(smallest_singular_value_ >= singular_value)) throw SingularSystem();
  } catch (const ComputationError&) {
    umfpack_dl_free_numeric(&numeric_);
    throw;
  }
}

GeneralFactorization::~GeneralFactorization() { umfpack_dl_free_numeric(&numeric_); }

Eigen::VectorXd GeneralFactorization::solve(int system, const Eigen::VectorXd& b) const {
  const Control settings = control();
  Eigen::VectorXd x = Eigen::VectorXd::Constant(b.size(), std::nan(""));
  const SuiteSparse_long status =
      umfpack_dl_solve(system, matrix_.outerIndexPtr(), matrix_.innerIndexPtr(), matrix_.valuePtr(),
                       x.data(), b.data(), numeric_, settings.data(), nullptr);
  require_success(status, b.size());
  return x;
}

Eigen::VectorXd GeneralFactorization::solve(const Eigen::VectorXd& right_hand_side) const {
  if (right_hand_side.size() != matrix_.rows())
    throw InvalidArgument("a factorisation of " + std::to_string(matrix_.rows()) +
                          " equations cannot take " + std::to_string(right_hand_side.size()) +
                          " right-hand sides");
  if (right_hand_side.size() == 0) return {};
  return solve(UMFPACK_A, right_hand_side);
}

}  // namespace rfm
