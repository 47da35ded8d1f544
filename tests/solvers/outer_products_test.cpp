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

TEST(LinearCombinations, AreFormedPointByPoint) {
  const int length = padded(9), points = 3;
  std::vector<double> a(length * points), b(length * points), result(length * points, 77);
  for (std::size_t i = 0; i < a.size(); ++i) {
    a[i] = double(i);
    b[i] = 100.0 - double(i * i);
  }
  const double alpha[] = {1, 2, -3}, beta[] = {5, 0, 7};
  const std::vector<WeightedVectors> terms{{alpha, a.data()}, {beta, b.data()}};
  linear_combinations(terms, points, length, result.data());
  for (int q = 0; q < points; ++q)
    for (int i = q * length; i < (q + 1) * length; ++i)
      EXPECT_EQ(result[i], alpha[q] * a[i] + beta[q] * b[i]);

  std::vector<double> sum(length, 1000);
  add_weighted_sum(terms[0], points, length, sum.data());
  for (int i = 0; i < length; ++i)
    EXPECT_EQ(sum[i], 1000 + a[i] + 2 * a[i + length] - 3 * a[i + 2 * length]);
}

}  // namespace
}  // namespace rfm
