#pragma once

#include <Eigen/Core>
#include <memory>
#include <span>

#include "core/error.hpp"
#include "solvers/linear_system.hpp"

namespace rfm {

/// That a system of equations is singular.
class SingularSystem : public ComputationError {
 public:
  SingularSystem();
};

/// Orderings that reduce fill, from the graph of the matrix alone: AMD is quicker in the plane; in
/// space METIS has less fill.
enum class Ordering { amd, metis };

/// The square roots of the diagonal, by which every system is scaled on both sides before it is
/// solved: S K S with S = diag(K)^−½ has unit diagonal, and splines that touch the region by a
/// sliver (diagonals down to 10⁻³⁰⁰ of the others) no longer spoil its condition.
struct DiagonalScaling {
  /// 1/√|K_ii|; 0 where |K_ii| < 10⁻³⁰⁰: such a spline is dropped, its coefficient is 0.
  Eigen::VectorXd factors;
  int dropped = 0;

  explicit DiagonalScaling(const SparseMatrix& lower);
  /// S K S, with a unit row for every dropped spline.
  SparseMatrix apply(const SparseMatrix& lower) const;
};

/// A factorisation of a symmetric matrix of unit or similar diagonal, given by its lower triangle:
/// supernodal Cholesky (CHOLMOD); if the matrix turns out to be indefinite, as with Nitsche's
/// method on small cuts, L D Lᵀ without pivoting.
class SymmetricFactorization {
 public:
  enum class Method { cholesky, ldlt };

  /// Throws `ComputationError` when a number is not finite or the matrix is singular to working
  /// precision: smallest_eigenvalue() < 10⁻¹⁴.
  SymmetricFactorization(const SparseMatrix& lower, Ordering ordering);
  /// The same with a given order of elimination.
  SymmetricFactorization(const SparseMatrix& lower, std::span<const std::int64_t> order);
  ~SymmetricFactorization();
  SymmetricFactorization(SymmetricFactorization&&) noexcept;
  SymmetricFactorization& operator=(SymmetricFactorization&&) noexcept;

  /// Not to be called by two threads at once: CHOLMOD keeps its state in the factorisation.
  Eigen::VectorXd solve(const Eigen::VectorXd& right_hand_side) const;
  Method method() const;
  /// The number of negative eigenvalues, as the signs of the pivots tell (J. J. Sylvester's law of
  /// inertia): of K − σ M the number of eigenvalues of K x = λ M x below σ.
  int negative_eigenvalues() const;
  /// The smallest |eigenvalue|, from above, by two steps of inverse iteration (within a factor of
  /// two, usually): for a matrix of unit diagonal about the reciprocal of its condition number.
  double smallest_eigenvalue() const;

 private:
  struct Factors;
  void factorize(const SparseMatrix& lower, Ordering ordering, std::span<const std::int64_t> order);
  std::unique_ptr<Factors> factors_;
};

}  // namespace rfm
