#include "problems/pinned_constant.hpp"

namespace rfm {

void pin_one(LinearSystem& system, std::optional<Eigen::Index> count) {
  Eigen::Index pinned = 0;
  const Eigen::VectorXd diagonal = system.matrix.diagonal();
  diagonal.head(count.value_or(diagonal.size())).maxCoeff(&pinned);
  for (Eigen::Index column = 0; column < system.matrix.outerSize(); ++column)
    for (SparseMatrix::InnerIterator entry(system.matrix, column); entry; ++entry)
      if (entry.row() == pinned || entry.col() == pinned)
        entry.valueRef() = entry.row() == entry.col() ? entry.value() : 0.0;
  system.right_hand_side[pinned] = 0;
}

}  // namespace rfm
