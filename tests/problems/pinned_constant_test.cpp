#include "problems/pinned_constant.hpp"

#include <gtest/gtest.h>

#include <Eigen/SparseCholesky>

namespace rfm {
namespace {

// −u'' = f on a chain of springs without supports, in which constants cost nothing.
LinearSystem chain(const std::vector<double>& loads) {
  const int n = static_cast<int>(loads.size());
  std::vector<Eigen::Triplet<double>> entries;
  for (int i = 0; i < n; ++i) {
    const bool inner = i > 0 && i + 1 < n;
    entries.emplace_back(i, i, inner ? 2 : 1);
    if (i > 0) entries.emplace_back(i, i - 1, -1);  // the lower triangle
  }
  LinearSystem system;
  system.matrix.resize(n, n);
  system.matrix.setFromTriplets(entries.begin(), entries.end());
  system.right_hand_side = Eigen::Map<const Eigen::VectorXd>(loads.data(), n);
  return system;
}

TEST(PinOne, LeavesASolutionUpToAConstantWhereLoadsBalance) {
  const LinearSystem original = chain({1, 0, 0, 2, -3});
  LinearSystem system = original;
  pin_one(system);
  const Eigen::SimplicialLLT<SparseMatrix, Eigen::Lower> factorization(system.matrix);
  ASSERT_EQ(factorization.info(), Eigen::Success);
  const Eigen::VectorXd u = factorization.solve(system.right_hand_side);
  EXPECT_EQ((u.array() == 0).count(), 1);
  const Eigen::VectorXd residual =
      original.matrix.selfadjointView<Eigen::Lower>() * u - original.right_hand_side;
  EXPECT_LT(residual.cwiseAbs().maxCoeff(), 1e-14);
}

TEST(PinOne, TakesTheBestSupportedUnknown) {
  LinearSystem system = chain({0, 0, 0});
  system.matrix.coeffRef(1, 1) = 7;
  pin_one(system);
  EXPECT_EQ(system.matrix.coeff(1, 0), 0);
  EXPECT_EQ(system.matrix.coeff(2, 1), 0);
  EXPECT_EQ(system.matrix.coeff(1, 1), 7);
}

}  // namespace
}  // namespace rfm
