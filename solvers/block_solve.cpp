#include "solvers/block_solve.hpp"

#include <algorithm>

#include "core/error.hpp"

namespace rfm {

LinearSolution solve_in_turn(const LinearSystem& system, std::span<const Eigen::Index> first,
                             const LinearSolverOptions& options) {
  if (first.size() < 2 || first.front() != 0 || first.back() != system.size() ||
      !std::ranges::is_sorted(first))
    throw InvalidArgument("blocks divide all coefficients of a system");
  const SparseMatrix whole = system.symmetric
                                 ? SparseMatrix(system.matrix.selfadjointView<Eigen::Lower>())
                                 : system.matrix;
  LinearSolution result;
  Eigen::VectorXd known = Eigen::VectorXd::Zero(system.size());
  for (std::size_t block = 0; block + 1 < first.size(); ++block) {
    const Eigen::Index begin = first[block], count = first[block + 1] - begin;
    LinearSystem own;
    own.symmetric = system.symmetric;
    const SparseMatrix columns = whole.middleCols(begin, count);
    own.matrix = columns.middleRows(begin, count);
    if (own.symmetric) own.matrix = SparseMatrix(own.matrix.triangularView<Eigen::Lower>());
    own.right_hand_side = (system.right_hand_side - whole * known).segment(begin, count);
    const LinearSolution solution = solve(own, options);
    known.segment(begin, count) = solution.coefficients;
    if (block == 0) {
      result = solution;
      continue;
    }
    result.relative_residual = std::max(result.relative_residual, solution.relative_residual);
    result.dropped += solution.dropped;
  }
  result.coefficients = known;
  return result;
}

}  // namespace rfm
