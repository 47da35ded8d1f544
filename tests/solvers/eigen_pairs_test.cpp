#include "solvers/eigen_pairs.hpp"

#include <gmock/gmock.h>

#include <Eigen/Eigenvalues>
#include <cmath>
#include <numbers>
#include <random>

#include "core/error.hpp"
#include "solvers/symmetric_factorization.hpp"

namespace rfm {
namespace {

using Entries = std::vector<Eigen::Triplet<double, std::int64_t>>;

SparseMatrix matrix(int size, const Entries& entries) {
  SparseMatrix lower(size, size);
  lower.setFromTriplets(entries.begin(), entries.end());
  return lower;
}

SparseMatrix identity(int size) {
  SparseMatrix one(size, size);
  one.setIdentity();
  return one;
}

// The sum of second differences along the axes of a cube of n^dimension points, fixed beyond its
// ends: eigenvalues Σ 4 sin²(π k / 2 (n + 1)), those with several different k multiple.
SparseMatrix differences(int n, int dimension) {
  int size = 1;
  for (int axis = 0; axis < dimension; ++axis) size *= n;
  Entries entries;
  for (int i = 0; i < size; ++i) {
    entries.emplace_back(i, i, 2.0 * dimension);
    for (int axis = 0, stride = 1; axis < dimension; ++axis, stride *= n)
      if (i / stride % n + 1 < n) entries.emplace_back(i + stride, i, -1.0);
  }
  return matrix(size, entries);
}

std::vector<double> known_eigenvalues(int n, int dimension) {
  std::vector<double> sums{0};
  for (int axis = 0; axis < dimension; ++axis) {
    std::vector<double> longer;
    for (const double sum : sums)
      for (int k = 1; k <= n; ++k)
        longer.push_back(sum + 4 * std::pow(std::sin(std::numbers::pi * k / (2 * (n + 1))), 2));
    sums = longer;
  }
  std::ranges::sort(sums);
  return sums;
}

void expect_known(const EigenPairs& result, const std::vector<double>& known, int first,
                  double tolerance = 1e-12) {
  EXPECT_EQ(result.found, result.present);
  for (std::size_t i = 0; i < result.pairs.size(); ++i)
    EXPECT_NEAR(result.pairs[i].value, known[first + i], tolerance * known[first + i]) << i;
}

class EveryDimension : public testing::TestWithParam<int> {};
INSTANTIATE_TEST_SUITE_P(EigenPairs, EveryDimension, testing::Values(1, 2, 3));

TEST_P(EveryDimension, AreThoseOfDifferencesWithEveryMultipleOne) {
  const int dimension = GetParam(), n = dimension == 1 ? 200 : dimension == 2 ? 25 : 9;
  const SparseMatrix k = differences(n, dimension), m = identity(static_cast<int>(k.rows()));
  const EigenPairs result = eigen_pairs(k, m, {.count = 20, .dimension = dimension});
  ASSERT_EQ(result.pairs.size(), 20);
  expect_known(result, known_eigenvalues(n, dimension), 0);
  for (const EigenPair& pair : result.pairs) EXPECT_LT(pair.residual, 1e-10);
}

TEST(EigenPairs, HaveVectorsOfUnitMassThatAreOrthogonalInIt) {
  const SparseMatrix k = differences(20, 2), m = 0.25 * identity(400);
  const EigenPairs result = eigen_pairs(k, m, {.count = 8});
  for (const EigenPair& a : result.pairs)
    for (const EigenPair& b : result.pairs)
      EXPECT_NEAR(0.25 * a.vector.dot(b.vector), &a == &b ? 1 : 0, 1e-12);
}

TEST(EigenPairs, AscendFromTheShiftAndIncludeOneThatLiesThere) {
  const SparseMatrix k = differences(30, 2), m = identity(900);
  const std::vector<double> known = known_eigenvalues(30, 2);
  const auto first = std::ranges::lower_bound(known, 0.3) - known.begin();
  ASSERT_GT(first, 10);
  expect_known(eigen_pairs(k, m, {.count = 12, .shift = 0.3}), known, static_cast<int>(first));
  const auto simple = std::ranges::find(known, known[first]) - known.begin();
  expect_known(eigen_pairs(k, m, {.count = 4, .shift = known[first]}), known,
               static_cast<int>(simple));
}

TEST(EigenPairs, BeginWithZeroWhereTheStiffnessHasAKernel) {
  Entries entries;  // free ends: eigenvalues 4 sin²(π k / 2 n), k = 0, 1, …
  constexpr int n = 120;
  for (int i = 0; i < n; ++i) {
    entries.emplace_back(i, i, i == 0 || i == n - 1 ? 1.0 : 2.0);
    if (i + 1 < n) entries.emplace_back(i + 1, i, -1.0);
  }
  const EigenPairs result = eigen_pairs(matrix(n, entries), identity(n), {.dimension = 1});
  EXPECT_NEAR(result.pairs[0].value, 0, 1e-14);
  for (int i = 1; i < 6; ++i) {
    const double known = 4 * std::pow(std::sin(std::numbers::pi * i / (2.0 * n)), 2);
    EXPECT_NEAR(result.pairs[i].value, known, 1e-11 * known);
  }
}

TEST(EigenPairs, DoNotDependOnTheScaleOfTheUnknowns) {
  SparseMatrix k = differences(20, 2), m = identity(400);
  std::mt19937 generator(3);
  std::uniform_real_distribution<double> exponent(-60, 0);
  Eigen::VectorXd scale(400);
  for (double& factor : scale) factor = std::pow(10.0, exponent(generator));
  for (SparseMatrix* lower : {&k, &m})
    for (int column = 0; column < 400; ++column)
      for (SparseMatrix::InnerIterator entry(*lower, column); entry; ++entry)
        entry.valueRef() *= scale[entry.row()] * scale[column];
  expect_known(eigen_pairs(k, m, {.count = 10}), known_eigenvalues(20, 2), 0);
}

TEST(EigenPairs, DoNotDependOnTheUnitsOfTheMatrices) {
  const SparseMatrix k = differences(20, 2), m = identity(400);
  const std::vector<double> known = known_eigenvalues(20, 2);
  for (const double unit : {1e-18, 1e-12, 1e12, 1e20}) {
    const EigenPairs result = eigen_pairs(k, SparseMatrix(m / unit), {.count = 10});
    EXPECT_EQ(result.found, result.present);
    for (int i = 0; i < 10; ++i) {
      EXPECT_NEAR(result.pairs[i].value / unit, known[i], 1e-12 * known[i]) << unit;
      EXPECT_LT(result.pairs[i].residual, 1e-9) << unit;
      EXPECT_NEAR(result.pairs[i].vector.squaredNorm() / unit, 1, 1e-12);
    }
    const EigenPairs above =
        eigen_pairs(k, SparseMatrix(m / unit), {.count = 4, .shift = 0.3 * unit});
    const auto first = std::ranges::lower_bound(known, 0.3) - known.begin();
    for (int i = 0; i < 4; ++i)
      EXPECT_NEAR(above.pairs[i].value / unit, known[first + i], 1e-11) << unit;
  }
}

TEST(EigenPairs, OfNegativeStiffnessOrMassAreRefused) {
  const SparseMatrix k = differences(20, 2), m = identity(400);
  EXPECT_THROW(eigen_pairs(SparseMatrix(-k), m, {.count = 6}), ComputationError);
  EXPECT_THROW(eigen_pairs(k, SparseMatrix(-m), {.count = 6}), ComputationError);
  SparseMatrix mixed = m;
  for (int i = 0; i < 400; ++i) mixed.coeffRef(i, i) = i % 20 - 9.5;
  EXPECT_THROW(eigen_pairs(k, mixed, {.count = 6}), ComputationError);
}

TEST(EigenPairs, AreNotDisturbedByVeryNegativeOnesNorByFunctionsWithoutSupport) {
  const SparseMatrix inner = differences(20, 2);
  Entries k, m;
  for (int column = 0; column < 400; ++column)
    for (SparseMatrix::InnerIterator entry(inner, column); entry; ++entry)
      k.emplace_back(entry.row(), column, entry.value());
  for (int i = 0; i < 402; ++i) m.emplace_back(i, i, i < 400 ? 1 : i == 400 ? 1e-3 : 0);
  k.emplace_back(400, 400, -50.0);  // as splines on small cuts have with Nitsche's method
  k.emplace_back(401, 401, 0.0);
  expect_known(eigen_pairs(matrix(402, k), matrix(402, m), {.count = 6}), known_eigenvalues(20, 2),
               0);
}

TEST(EigenPairs, OfRandomMatricesAreThoseOfADenseSolver) {
  std::mt19937 generator(5);
  std::normal_distribution<double> normal;
  constexpr int n = 60;
  const auto random = [&](double diagonal) {
    Entries entries;
    for (int i = 0; i < n; ++i) {
      entries.emplace_back(i, i, diagonal + std::abs(normal(generator)));
      for (int j = i + 1; j < std::min(n, i + 6); ++j)
        entries.emplace_back(j, i, normal(generator));
    }
    return matrix(n, entries);
  };
  const SparseMatrix k = random(0), m = random(12);
  const auto dense = [](const SparseMatrix& lower) {
    return Eigen::MatrixXd(Eigen::MatrixXd(lower).selfadjointView<Eigen::Lower>());
  };
  const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd> all(dense(k), dense(m));
  for (const double shift : {-2.0, -0.1, 0.0, 0.2}) {
    const auto first = (all.eigenvalues().array() < shift).count();
    const EigenPairs result = eigen_pairs(k, m, {.count = 7, .shift = shift, .dimension = 1});
    for (int i = 0; i < 7; ++i)
      EXPECT_NEAR(result.pairs[i].value, all.eigenvalues()[first + i], 1e-11) << shift << " " << i;
  }
}

TEST(EigenPairs, OfFewUnknownsCanAllBeFound) {
  const std::vector<double> known = known_eigenvalues(5, 1);
  expect_known(eigen_pairs(differences(5, 1), identity(5), {.count = 5, .dimension = 1}), known, 0);
  EXPECT_THROW(eigen_pairs(differences(5, 1), identity(5), {.count = 6, .dimension = 1}),
               ComputationError);
  expect_known(eigen_pairs(differences(1, 1), identity(1), {.count = 1, .dimension = 1}), {2}, 0);
}

TEST(EigenPairs, RefuseWhatDoesNotFit) {
  EXPECT_THROW(eigen_pairs(identity(4), identity(3)), InvalidArgument);
  EXPECT_THROW(eigen_pairs(identity(4), identity(4), {.count = 0}), InvalidArgument);
  EXPECT_THROW(eigen_pairs(identity(4), matrix(4, {}), {.count = 1}), ComputationError);
}

TEST(Inertia, CountsTheEigenvaluesBelowAShift) {
  const SparseMatrix k = differences(15, 2);
  const std::vector<double> known = known_eigenvalues(15, 2);
  for (const double shift : {0.01, 0.2, 1.0, 4.05, 7.9}) {
    const SymmetricFactorization factors(SparseMatrix(k - shift * identity(225)), Ordering::amd);
    EXPECT_EQ(factors.negative_eigenvalues(),
              std::ranges::lower_bound(known, shift) - known.begin());
  }
}

}  // namespace
}  // namespace rfm
