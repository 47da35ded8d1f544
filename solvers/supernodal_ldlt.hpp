#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "solvers/linear_system.hpp"

namespace rfm {

/// Where the factor of a sparse matrix has entries: neighbouring columns with the same rows below
/// the diagonal form a *supernode*, one dense block.
struct SupernodalStructure {
  /// permutation[i] is the equation eliminated at step i.
  std::vector<std::int64_t> permutation;
  /// Supernode s owns the columns first_column[s] … first_column[s + 1] − 1 of the permuted matrix,
  std::vector<std::int64_t> first_column;
  /// and has entries in the rows rows[row_begin[s]] … rows[row_begin[s + 1] − 1], ascending; the
  /// first of them are its own columns.
  std::vector<std::int64_t> row_begin;
  std::vector<std::int64_t> rows;

  int count() const { return static_cast<int>(first_column.size()) - 1; }
};

/// P A Pᵀ = L D Lᵀ with unit lower triangular L and diagonal D of any signs, for symmetric matrices
/// that are not positive definite: a left-looking supernodal method, whose work is products of
/// dense blocks. Pivots are not exchanged, so that the fill is that of a Cholesky factor; stability
/// then is not guaranteed but must be seen from residuals. It holds for matrices that are positive
/// definite but for a few directions, as those of Nitsche's method on small cuts.
class SupernodalLdlt {
 public:
  SupernodalLdlt(const SparseMatrix& lower, SupernodalStructure structure);

  Eigen::VectorXd solve(const Eigen::VectorXd& right_hand_side) const;
  /// D. A zero or a number that is not finite says that the factorisation failed.
  const Eigen::VectorXd& pivots() const { return pivots_; }

 private:
  using Block = Eigen::Map<Eigen::MatrixXd>;
  using ConstBlock = Eigen::Map<const Eigen::MatrixXd>;
  std::int64_t width(int supernode) const;
  std::int64_t height(int supernode) const;
  const std::int64_t* rows(int supernode) const;
  Block block(int supernode);
  ConstBlock block(int supernode) const;
  void subtract_descendant(int descendant, std::int64_t first, std::int64_t last, int supernode,
                           const std::vector<std::int64_t>& place);
  void eliminate(int supernode);

  SupernodalStructure structure_;
  std::vector<std::size_t> begin_;  // of the blocks in values_
  std::vector<double> values_;
  Eigen::VectorXd pivots_;
  Eigen::MatrixXd scaled_, update_;
};

}  // namespace rfm
