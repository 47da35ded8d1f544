#include "solvers/conjugate_gradient.hpp"

#include <gmock/gmock.h>

namespace rfm {
namespace {

using Outcome = ConjugateGradientResult::Outcome;

// Unit diagonal, −½ beside it scaled by `coupling`: eigenvalues 1 − coupling cos(k π / (n + 1)).
SparseMatrix chain(int size, double coupling) {
  std::vector<Eigen::Triplet<double, std::int64_t>> entries;
  for (int i = 0; i < size; ++i) entries.emplace_back(i, i, 1.0);
  for (int i = 0; i + 1 < size; ++i) entries.emplace_back(i + 1, i, -0.5 * coupling);
  SparseMatrix lower(size, size);
  lower.setFromTriplets(entries.begin(), entries.end());
  return lower;
}

Eigen::VectorXd sample(int size) {
  Eigen::VectorXd vector(size);
  for (int i = 0; i < size; ++i) vector[i] = std::cos(3 * i);
  return vector;
}

TEST(ConjugateGradient, ConvergesInAsManyStepsAsTheConditionAllows) {
  const SparseMatrix lower = chain(200, 0.9);  // condition 19
  const Eigen::VectorXd exact = sample(200);
  const ConjugateGradientResult result =
      conjugate_gradient(lower, lower.selfadjointView<Eigen::Lower>() * exact, 1e-12, 1000);
  EXPECT_EQ(result.outcome, Outcome::converged);
  EXPECT_LE(result.relative_residual, 1e-12);
  EXPECT_LT((result.solution - exact).norm(), 2e-11 * exact.norm());
  EXPECT_LE(result.iterations, 0.5 * std::sqrt(19) * std::log(2e12 * std::sqrt(19)) + 1);
}

TEST(ConjugateGradient, IsExactAfterAsManyStepsAsUnknowns) {
  const SparseMatrix lower = chain(6, 0.99);
  const ConjugateGradientResult result = conjugate_gradient(lower, sample(6), 1e-12, 6);
  EXPECT_EQ(result.outcome, Outcome::converged);
}

TEST(ConjugateGradient, NoticesAMatrixThatIsNotPositiveDefinite) {
  const ConjugateGradientResult result =
      conjugate_gradient(chain(50, 1.5), sample(50), 1e-12, 10'000);
  EXPECT_EQ(result.outcome, Outcome::indefinite);
}

TEST(ConjugateGradient, StopsAtItsLimit) {
  const ConjugateGradientResult result = conjugate_gradient(chain(200, 0.9), sample(200), 1e-12, 5);
  EXPECT_EQ(result.outcome, Outcome::stalled);
  EXPECT_EQ(result.iterations, 5);
  EXPECT_GT(result.relative_residual, 1e-12);
}

TEST(ConjugateGradient, NothingOnTheRightGivesNothing) {
  const ConjugateGradientResult result =
      conjugate_gradient(chain(5, 0.9), Eigen::VectorXd::Zero(5), 1e-12, 10);
  EXPECT_EQ(result.outcome, Outcome::converged);
  EXPECT_EQ(result.solution.norm(), 0);
}

}  // namespace
}  // namespace rfm
