#include "solvers/outer_products.hpp"

#include <gmock/gmock.h>

#include <random>
#include <vector>

namespace rfm {
namespace {

class OuterProducts : public testing::TestWithParam<std::tuple<int, int, int>> {};
INSTANTIATE_TEST_SUITE_P(Sizes, OuterProducts,
                         testing::Combine(testing::Values(4, 9, 16, 27, 36, 64),
                                          testing::Values(4, 16, 27), testing::Values(1, 17)));

TEST_P(OuterProducts, EqualTheSumWrittenOut) {
  const auto [row_count, column_count, points] = GetParam();
  const int rows = padded(row_count), columns = padded(column_count);
  std::mt19937 generator(1);
  std::uniform_int_distribution<int> digit(-9, 9);  // whole numbers: products are exact
  const auto vectors = [&](int length) {
    std::vector<double> numbers(std::size_t(length) * points);
    for (double& number : numbers) number = digit(generator);
    return numbers;
  };
  const std::vector<double> a = vectors(rows), b = vectors(columns), c = vectors(rows),
                            d = vectors(columns);
  const std::vector<VectorPair> pairs{{a.data(), b.data()}, {c.data(), d.data()}};
  std::vector<double> full(std::size_t(rows) * columns, 77);
  std::vector<double> lower = full;
  outer_products(pairs, points, rows, columns, false, full.data());
  outer_products(pairs, points, rows, columns, true, lower.data());
  for (int j = 0; j < columns; ++j)
    for (int i = 0; i < rows; ++i) {
      double sum = 0;
      for (int q = 0; q < points; ++q)
        sum += a[i + q * rows] * b[j + q * columns] + c[i + q * rows] * d[j + q * columns];
      EXPECT_EQ(full[i + j * rows], sum);
      if (i >= j) {
        EXPECT_EQ(lower[i + j * rows], sum);
      }
    }
}

class LinearCombinations : public testing::TestWithParam<int> {};
INSTANTIATE_TEST_SUITE_P(NumbersOfTerms, LinearCombinations, testing::Range(1, 6));

TEST_P(LinearCombinations, AreFormedPointByPoint) {
  const int count = GetParam(), length = padded(9), points = 3;
  std::vector<std::vector<double>> weights(count), vectors(count);
  std::vector<WeightedVectors> terms;
  for (int t = 0; t < count; ++t) {
    weights[t] = {1.0 + t, 2.0 - 3 * t, 5.0 * t};
    for (int i = 0; i < length * points; ++i) vectors[t].push_back((i * (t + 3)) % 17);
    terms.push_back({weights[t].data(), vectors[t].data()});
  }
  std::vector<double> result(length * points, 77);
  linear_combinations(terms, points, length, result.data());
  for (int q = 0; q < points; ++q)
    for (int i = q * length; i < (q + 1) * length; ++i) {
      double expected = 0;
      for (int t = 0; t < count; ++t) expected += weights[t][q] * vectors[t][i];
      EXPECT_EQ(result[i], expected);
    }
}

TEST(AddWeightedSum, AddsOverPoints) {
  const int length = padded(5);
  std::vector<double> vectors(length * 3), sum(length, 1000);
  for (std::size_t i = 0; i < vectors.size(); ++i) vectors[i] = double(i * i);
  const double weights[] = {1, 2, -3};
  add_weighted_sum({weights, vectors.data()}, 3, length, sum.data());
  for (int i = 0; i < length; ++i)
    EXPECT_EQ(sum[i], 1000 + vectors[i] + 2 * vectors[i + length] - 3 * vectors[i + 2 * length]);
}

}  // namespace
}  // namespace rfm
