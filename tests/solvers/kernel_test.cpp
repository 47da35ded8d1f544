#include "solvers/kernel.hpp"

#include <gmock/gmock.h>

#include "core/error.hpp"
#include "solvers/linear_solver.hpp"

namespace rfm {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

LinearSystem system_of(const MatrixXd& matrix, const VectorXd& load, bool symmetric) {
  LinearSystem system;
  const MatrixXd stored = symmetric ? MatrixXd(matrix.triangularView<Eigen::Lower>()) : matrix;
  system.matrix = stored.sparseView();
  system.symmetric = symmetric;
  system.right_hand_side = load;
  return system;
}

// Springs between neighbours of a chain, of stiffness 1, 2, …, free at both ends.
MatrixXd chain(int count) {
  MatrixXd matrix = MatrixXd::Zero(count, count);
  for (int i = 0; i + 1 < count; ++i) {
    matrix(i, i) += i + 1;
    matrix(i + 1, i + 1) += i + 1;
    matrix(i, i + 1) = matrix(i + 1, i) = -(i + 1);
  }
  return matrix;
}

TEST(Kernel, FreeChainIsSolvedUpToItsMotion) {
  const MatrixXd matrix = chain(6);
  VectorXd load = VectorXd::LinSpaced(6, -5, 5);  // in balance
  for (const bool symmetric : {true, false}) {
    const LinearSystem system = system_of(matrix, load, symmetric);
    const Kernel kernel(system, VectorXd::Ones(6));
    ASSERT_EQ(kernel.size(), 1);
    const VectorXd solution = solve(kernel.pinned(system)).coefficients;
    EXPECT_LT((matrix * solution - load).norm(), 1e-13);
    EXPECT_LT(kernel.incompatibility(system, solution), 1e-14);
    EXPECT_THROW(solve(system), ComputationError) << "without the candidate it is singular";
  }
}

TEST(Kernel, LoadsOutOfBalanceAreMeasuredByTheirResultant) {
  VectorXd load = VectorXd::Zero(6);
  load[1] = 3;
  load[4] = -1;
  const LinearSystem system = system_of(chain(6), load, true);
  const Kernel kernel(system, VectorXd::Ones(6));
  const VectorXd solution = solve(kernel.pinned(system)).coefficients;
  // The resultant 2 is left at the one equation that was given up, of loads of 4 in all; the
  // scaling of equations, within a factor of 6 of each other, weights both.
  EXPECT_GT(kernel.incompatibility(system, solution), 0.5 / 6);
  EXPECT_LT(kernel.incompatibility(system, solution), 0.5 * 6);
}

TEST(Kernel, CombinationsOfCandidatesCount) {
  MatrixXd matrix = MatrixXd::Zero(6, 6);  // two chains, coupled: neither moves by itself
  matrix.topLeftCorner(3, 3) = chain(3);
  matrix.bottomRightCorner(3, 3) = chain(3);
  matrix(0, 0) += 4;
  matrix(5, 5) += 1;
  matrix(0, 5) = matrix(5, 0) = -2;  // (2 a - b)^2: a = 1, b = 2 is free
  MatrixXd candidates = MatrixXd::Zero(6, 2);
  candidates.col(0).head(3).setOnes();
  candidates.col(1).tail(3).setOnes();
  const Kernel kernel(system_of(matrix, VectorXd::Zero(6), true), candidates);
  ASSERT_EQ(kernel.size(), 1);
  EXPECT_NEAR(kernel.weights()(1, 0), 2 * kernel.weights()(0, 0),
              1e-12 * std::abs(kernel.weights()(1, 0)));
}

TEST(Kernel, WhatIsHeldHoweverSoftlyIsNone) {
  MatrixXd matrix = chain(6);
  matrix(2, 2) += 1e-8;
  EXPECT_EQ(Kernel(system_of(matrix, VectorXd::Zero(6), true), VectorXd::Ones(6)).size(), 0);
  matrix(2, 2) = chain(6)(2, 2) + 1e-14;  // below rounding of the rest
  EXPECT_EQ(Kernel(system_of(matrix, VectorXd::Zero(6), true), VectorXd::Ones(6)).size(), 1);
}

TEST(Kernel, WhatABetterRuleMakesSmallerIsAnErrorOfQuadrature) {
  const auto held = [](double softly) {
    MatrixXd matrix = chain(6);
    matrix(2, 2) += softly;
    return system_of(matrix, VectorXd::Zero(6), true);
  };
  const auto size = [&](double softly, double better) {
    return Kernel(held(softly), VectorXd::Ones(6), [&] { return held(better); }).size();
  };
  EXPECT_EQ(size(1e-7, 1e-10), 1);
  EXPECT_EQ(size(1e-7, 0.9e-7), 0);
  EXPECT_EQ(size(1e-2, 1e-10), 0);  // beyond doubt
}

TEST(Kernel, DoesNotDependOnTheSizesOfUnknownsAndEquations) {
  const VectorXd sizes = (VectorXd(6) << 1e-9, 1, 1e7, 1e-3, 1e4, 1).finished();
  const MatrixXd matrix = sizes.asDiagonal() * chain(6) * sizes.asDiagonal();
  const VectorXd free = sizes.cwiseInverse();
  EXPECT_EQ(Kernel(system_of(matrix, VectorXd::Zero(6), true), free).size(), 1);
  EXPECT_EQ(Kernel(system_of(matrix, VectorXd::Zero(6), false), free).size(), 1);
  EXPECT_EQ(Kernel(system_of(matrix, VectorXd::Zero(6), true), VectorXd::Ones(6)).size(), 0);
}

TEST(Kernel, CandidatesOfAnotherLengthAreRefused) {
  EXPECT_THROW(Kernel(system_of(chain(6), VectorXd::Zero(6), true), VectorXd::Ones(5)),
               InvalidArgument);
}

}  // namespace
}  // namespace rfm
