#include "solvers/rank_revealing.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>

#include "core/error.hpp"
#include "solvers/linear_solver.hpp"

namespace rfm {
namespace {

// B Bᵀ with `rank` columns of cosines, minus the last if `indefinite`.
Eigen::MatrixXd matrix_of_rank(int rank, bool indefinite = false) {
  Eigen::MatrixXd factor(30, rank);
  for (int i = 0; i < 30; ++i)
    for (int j = 0; j < rank; ++j) factor(i, j) = std::cos(0.7 * i * j + j);
  Eigen::VectorXd signs = Eigen::VectorXd::Ones(rank);
  if (indefinite) signs[rank - 1] = -1;
  return factor * signs.asDiagonal() * factor.transpose();
}

SparseMatrix lower(const Eigen::MatrixXd& matrix) {
  return SparseMatrix(matrix.sparseView()).triangularView<Eigen::Lower>();
}

TEST(RankRevealing, FindsTheShortestSolutionOfASingularSystem) {
  for (const bool indefinite : {false, true}) {
    const Eigen::MatrixXd matrix = matrix_of_rank(11, indefinite);
    const Eigen::VectorXd load = matrix * Eigen::VectorXd::LinSpaced(30, -1, 2);
    const RankRevealing factorization(lower(matrix));
    EXPECT_EQ(factorization.dependent(), 19);
    const Eigen::VectorXd solution = factorization.solve(load);
    EXPECT_LT((matrix * solution - load).norm(), 1e-12 * load.norm());
    const Eigen::VectorXd shortest = matrix.completeOrthogonalDecomposition().solve(load);
    EXPECT_LT((solution - shortest).norm(), 1e-10 * shortest.norm());
    const Eigen::JacobiSVD<Eigen::MatrixXd> svd(matrix);
    EXPECT_NEAR(factorization.smallest_kept(), svd.singularValues()[10], 1e-12);
  }
}

TEST(RankRevealing, LeavesNothingOutOfARegularSystem) {
  const Eigen::MatrixXd matrix = Eigen::MatrixXd::Identity(30, 30) + matrix_of_rank(4);
  const RankRevealing factorization(lower(matrix));
  EXPECT_EQ(factorization.dependent(), 0);
  EXPECT_NEAR(factorization.smallest_kept(), 1, 1e-12);
}

TEST(RankRevealing, RefusesZero) {
  EXPECT_THROW(RankRevealing(lower(Eigen::MatrixXd::Zero(3, 3))), ComputationError);
}

TEST(LinearSolver, SolvesWhatIsSingularOnlyWhereAskedTo) {
  LinearSystem system;
  const Eigen::MatrixXd matrix = matrix_of_rank(11);
  system.matrix = lower(matrix);
  system.right_hand_side = matrix * Eigen::VectorXd::LinSpaced(30, -1, 2);
  EXPECT_THROW(solve(system), ComputationError);
  const LinearSolution solution = solve(system, {.rank_revealing = true});
  EXPECT_EQ(solution.method, LinearSolution::Method::eigenvectors);
  EXPECT_EQ(solution.dependent, 19);
  EXPECT_LT(solution.relative_residual, 1e-12);
  system.matrix = lower(matrix + Eigen::MatrixXd::Identity(30, 30));
  const LinearSolution regular = solve(system, {.rank_revealing = true});
  EXPECT_EQ(regular.method, LinearSolution::Method::cholesky);
  EXPECT_EQ(regular.dependent, 0);
}

}  // namespace
}  // namespace rfm
