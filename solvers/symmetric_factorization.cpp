#include "solvers/symmetric_factorization.hpp"

#include <cholmod.h>

#include <cmath>
#include <type_traits>

#include "solvers/blas_threads.hpp"
#include "solvers/supernodal_ldlt.hpp"

namespace rfm {
namespace {

static_assert(std::is_same_v<SuiteSparse_long, std::int64_t>);

constexpr double smallest_diagonal = 1e-300;
constexpr double singular_eigenvalue = 1e-14;  // an exact zero comes out as some 1e-16

}  // namespace

SingularSystem::SingularSystem()
    : ComputationError(
          "the system of equations is singular: the problem does not determine its solution. "
          "Perhaps a condition is missing (with fluxes prescribed on the whole boundary a solution "
          "is determined up to a constant only), or two undetermined functions describe the same "
          "thing") {}

DiagonalScaling::DiagonalScaling(const SparseMatrix& lower) : factors(lower.diagonal()) {
  for (double& entry : factors) {
    if (!std::isfinite(entry))
      throw ComputationError("the system of equations contains a number that is not finite");
    const double size = std::abs(entry);
    dropped += size < smallest_diagonal;
    entry = size < smallest_diagonal ? 0 : 1 / std::sqrt(size);
  }
}

SparseMatrix DiagonalScaling::apply(const SparseMatrix& lower) const {
  SparseMatrix scaled = lower;
  for (Eigen::Index column = 0; column < scaled.outerSize(); ++column)
    for (SparseMatrix::InnerIterator entry(scaled, column); entry; ++entry) {
      const double row_factor = factors[entry.row()];
      // One factor at a time: the product of two may overflow.
      entry.valueRef() = (entry.value() * row_factor) * factors[column];
      if (entry.row() == column && row_factor == 0) entry.valueRef() = 1;
    }
  return scaled;
}

struct SymmetricFactorization::Factors {
  Method method = Method::cholesky;
  double smallest_eigenvalue = 1;
  Eigen::Index size = 0;
  mutable cholmod_common common{};
  cholmod_factor* cholesky = nullptr;
  std::unique_ptr<const SupernodalLdlt> ldlt;

  Factors() {
    use_one_thread_in_blas();
    cholmod_l_start(&common);
    common.print = 0;
    common.supernodal = CHOLMOD_SUPERNODAL;
    common.nmethods = 1;
    common.postorder = 1;
  }
  ~Factors() {
    cholmod_l_free_factor(&cholesky, &common);
    cholmod_l_finish(&common);
  }

  bool factorize_positive(const SparseMatrix& lower, Ordering ordering,
                          std::span<const std::int64_t> order) {
    common.method[0].ordering = !order.empty()              ? CHOLMOD_GIVEN
                                : ordering == Ordering::amd ? CHOLMOD_AMD
                                                            : CHOLMOD_METIS;
    cholmod_sparse view{};
    view.nrow = view.ncol = static_cast<std::size_t>(lower.rows());
    view.nzmax = static_cast<std::size_t>(lower.nonZeros());
    view.p = const_cast<std::int64_t*>(lower.outerIndexPtr());
    view.i = const_cast<std::int64_t*>(lower.innerIndexPtr());
    view.x = const_cast<double*>(lower.valuePtr());
    view.stype = -1;  // only the lower triangle is stored
    view.itype = CHOLMOD_LONG;
    view.xtype = CHOLMOD_REAL;
    view.dtype = CHOLMOD_DOUBLE;
    view.sorted = view.packed = 1;
    cholesky = cholmod_l_analyze_p(
        &view, order.empty() ? nullptr : const_cast<std::int64_t*>(order.data()), nullptr, 0,
        &common);
    if (cholesky != nullptr) cholmod_l_factorize(&view, cholesky, &common);
    if (common.status == CHOLMOD_NOT_POSDEF) return false;
    if (common.status == CHOLMOD_OUT_OF_MEMORY)
      throw ComputationError("not enough memory to factorise a system of " +
                             std::to_string(lower.rows()) + " equations");
    if (common.status < CHOLMOD_OK || cholesky == nullptr)
      throw ComputationError("the factorisation of the system of equations failed (CHOLMOD " +
                             std::to_string(common.status) + ")");
    return true;
  }

  // The fill of both factorisations is the same, and CHOLMOD has analysed it.
  void factorize_indefinite(const SparseMatrix& lower) {
    const auto copy = [](const void* numbers, std::size_t count) {
      const auto* begin = static_cast<const std::int64_t*>(numbers);
      return std::vector<std::int64_t>(begin, begin + count);
    };
    SupernodalStructure structure;
    structure.permutation = copy(cholesky->Perm, cholesky->n);
    structure.first_column = copy(cholesky->super, cholesky->nsuper + 1);
    structure.row_begin = copy(cholesky->pi, cholesky->nsuper + 1);
    structure.rows = copy(cholesky->s, cholesky->ssize);
    cholmod_l_free_factor(&cholesky, &common);
    method = Method::ldlt;
    ldlt = std::make_unique<SupernodalLdlt>(lower, std::move(structure));
  }
};

SymmetricFactorization::SymmetricFactorization(const SparseMatrix& lower, Ordering ordering)
    : factors_(std::make_unique<Factors>()) {
  factorize(lower, ordering, {});
}

SymmetricFactorization::SymmetricFactorization(const SparseMatrix& lower,
                                               std::span<const std::int64_t> order)
    : factors_(std::make_unique<Factors>()) {
  if (order.size() != static_cast<std::size_t>(lower.rows()))
    throw InvalidArgument("an order of elimination must hold every equation once");
  factorize(lower, Ordering::amd, order);
}

void SymmetricFactorization::factorize(const SparseMatrix& lower, Ordering ordering,
                                       std::span<const std::int64_t> order) {
  factors_->size = lower.rows();
  if (lower.rows() != lower.cols() || !lower.isCompressed())
    throw InvalidArgument("a factorisation needs a square, compressed matrix");
  if (lower.nonZeros() > 0 && !lower.coeffs().allFinite())
    throw ComputationError("the system of equations contains a number that is not finite");
  if (lower.rows() == 0) return;
  if (!factors_->factorize_positive(lower, ordering, order)) factors_->factorize_indefinite(lower);
  // Pivots alone do not tell: that of a singular matrix is rounding, but of the size n ε.
  Eigen::VectorXd vector(lower.rows());
  for (Eigen::Index i = 0; i < vector.size(); ++i) vector[i] = 1 + 0.5 * std::sin(1.7 * double(i));
  for (int step = 0; step < 2; ++step) {
    vector.normalize();
    vector = solve(vector);
  }
  factors_->smallest_eigenvalue = 1 / vector.norm();
  if (!(factors_->smallest_eigenvalue >= singular_eigenvalue)) throw SingularSystem();
}

SymmetricFactorization::~SymmetricFactorization() = default;
SymmetricFactorization::SymmetricFactorization(SymmetricFactorization&&) noexcept = default;
SymmetricFactorization& SymmetricFactorization::operator=(SymmetricFactorization&&) noexcept =
    default;

Eigen::VectorXd SymmetricFactorization::solve(const Eigen::VectorXd& right_hand_side) const {
  if (right_hand_side.size() != factors_->size)
    throw InvalidArgument("a factorisation of " + std::to_string(factors_->size) +
                          " equations cannot take " + std::to_string(right_hand_side.size()) +
                          " right-hand sides");
  if (factors_->size == 0) return {};
  if (factors_->method == Method::ldlt) return factors_->ldlt->solve(right_hand_side);
  cholmod_dense view{};
  view.nrow = view.d = view.nzmax = static_cast<std::size_t>(right_hand_side.size());
  view.ncol = 1;
  view.x = const_cast<double*>(right_hand_side.data());
  view.xtype = CHOLMOD_REAL;
  view.dtype = CHOLMOD_DOUBLE;
  cholmod_dense* result = cholmod_l_solve(CHOLMOD_A, factors_->cholesky, &view, &factors_->common);
  if (result == nullptr) throw ComputationError("not enough memory to solve the system");
  const Eigen::VectorXd solution =
      Eigen::Map<const Eigen::VectorXd>(static_cast<double*>(result->x), right_hand_side.size());
  cholmod_l_free_dense(&result, &factors_->common);
  return solution;
}

SymmetricFactorization::Method SymmetricFactorization::method() const { return factors_->method; }
int SymmetricFactorization::negative_eigenvalues() const {
  return factors_->ldlt ? static_cast<int>((factors_->ldlt->pivots().array() < 0).count()) : 0;
}
double SymmetricFactorization::smallest_eigenvalue() const { return factors_->smallest_eigenvalue; }

}  // namespace rfm
