#include "solvers/block_solve.hpp"

#include <Eigen/LU>

#include <gmock/gmock.h>

#include "core/error.hpp"

namespace rfm {
namespace {

// K, its lower triangle if symmetric.
LinearSystem system_of(const Eigen::MatrixXd& matrix, const Eigen::VectorXd& load, bool symmetric) {
  LinearSystem system;
  system.symmetric = symmetric;
  const Eigen::MatrixXd stored =
      symmetric ? Eigen::MatrixXd(matrix.triangularView<Eigen::Lower>()) : matrix;
  system.matrix = SparseMatrix(stored.sparseView());
  system.right_hand_side = load;
  return system;
}

class BlockSolveOfAnySymmetry : public testing::TestWithParam<bool> {};
INSTANTIATE_TEST_SUITE_P(BlockSolve, BlockSolveOfAnySymmetry, testing::Bool());

TEST_P(BlockSolveOfAnySymmetry, KeepsWhatWasSolvedBefore) {
  Eigen::MatrixXd matrix(4, 4);
  matrix << 5, 1, 2, 0.5, 1, 4, 1, 1, 2, 1, 6, 1, 0.5, 1, 1, 3;
  if (!GetParam()) matrix(0, 3) = -1, matrix(3, 1) = 2;
  const Eigen::VectorXd load = Eigen::Vector4d(1, -2, 3, 0.5);
  const std::vector<Eigen::Index> first{0, 2, 3, 4};
  const Eigen::VectorXd c = solve_in_turn(system_of(matrix, load, GetParam()), first).coefficients;
  Eigen::VectorXd expected(4);
  expected.head(2) = matrix.topLeftCorner(2, 2).lu().solve(load.head(2));
  expected[2] = (load[2] - matrix.row(2).head(2) * expected.head(2)) / matrix(2, 2);
  expected[3] = (load[3] - matrix.row(3).head(3) * expected.head(3)) / matrix(3, 3);
  EXPECT_LT((c - expected).norm(), 1e-14);
}

TEST(BlockSolve, OfOneBlockIsTheWholeSystem) {
  Eigen::MatrixXd matrix(2, 2);
  matrix << 3, 1, 1, 2;
  const std::vector<Eigen::Index> first{0, 2};
  const Eigen::VectorXd c =
      solve_in_turn(system_of(matrix, Eigen::Vector2d(4, 3), true), first).coefficients;
  EXPECT_LT((c - Eigen::Vector2d(1, 1)).norm(), 1e-14);
}

TEST(BlockSolve, RefusesBlocksThatLeaveOutCoefficients) {
  const LinearSystem system =
      system_of(Eigen::MatrixXd::Identity(3, 3), Eigen::Vector3d::Ones(), true);
  for (const std::vector<Eigen::Index>& first :
       {std::vector<Eigen::Index>{0, 2}, {1, 3}, {0}, {0, 2, 1, 3}})
    EXPECT_THROW(solve_in_turn(system, first), InvalidArgument);
}

}  // namespace
}  // namespace rfm
