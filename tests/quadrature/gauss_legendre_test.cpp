#include "quadrature/gauss_legendre.hpp"

#include <gmock/gmock.h>

#include <cmath>

#include "core/error.hpp"

using namespace rfm;

namespace {

double legendre(int n, double z) {
  double value = 1, previous = 0;
  for (int k = 0; k < n; ++k) {
    const double next = ((2 * k + 1) * z * value - k * previous) / (k + 1);
    previous = value;
    value = next;
  }
  return value;
}

template <class Function>
double integral(const GaussRule& rule, Function&& function) {
  double sum = 0;
  for (int i = 0; i < rule.size(); ++i) sum += rule.weights[i] * function(rule.nodes[i]);
  return sum;
}

class EveryGaussRule : public testing::TestWithParam<int> {};
INSTANTIATE_TEST_SUITE_P(GaussLegendre, EveryGaussRule, testing::Range(1, max_gauss_points + 1));

TEST_P(EveryGaussRule, IsExactForDegreeTwoNMinusOne) {
  const GaussRule& rule = gauss_legendre(GetParam());
  for (int degree = 0; degree < 2 * GetParam(); ++degree)
    EXPECT_NEAR(integral(rule, [&](double x) { return std::pow(x, degree); }), 1.0 / (degree + 1),
                1e-15)
        << "degree " << degree;
}

TEST_P(EveryGaussRule, IsNotExactForDegreeTwoN) {
  // P_n² vanishes at every node, but its integral over [0, 1] of P_n(2x − 1)² is 1 / (2n + 1).
  const int n = GetParam();
  const double sum = integral(gauss_legendre(n), [&](double x) {
    const double value = legendre(n, 2 * x - 1);
    return value * value;
  });
  EXPECT_LT(sum, 1e-20);
}

TEST_P(EveryGaussRule, IsSymmetricWithPositiveWeightsAndAscendingNodes) {
  const GaussRule& rule = gauss_legendre(GetParam());
  const int n = rule.size();
  ASSERT_EQ(n, GetParam());
  for (int i = 0; i < n; ++i) {
    EXPECT_GT(rule.weights[i], 0);
    EXPECT_EQ(rule.weights[i], rule.weights[n - 1 - i]);
    EXPECT_NEAR(rule.nodes[i] + rule.nodes[n - 1 - i], 1, 2e-16);
    EXPECT_GT(rule.nodes[i], i > 0 ? rule.nodes[i - 1] : 0);
  }
}

TEST(GaussLegendre, ThreePointsAreThoseOfTheTextbook) {
  const GaussRule& rule = gauss_legendre(3);
  EXPECT_DOUBLE_EQ(rule.nodes[0], 0.5 - std::sqrt(0.15));
  EXPECT_EQ(rule.nodes[1], 0.5);
  EXPECT_DOUBLE_EQ(rule.weights[0], 5.0 / 18);
  EXPECT_DOUBLE_EQ(rule.weights[1], 4.0 / 9);
}

TEST(GaussLegendre, NumbersOfPointsOutOfRangeAreRefused) {
  EXPECT_THROW(gauss_legendre(0), InvalidArgument);
  EXPECT_THROW(gauss_legendre(max_gauss_points + 1), InvalidArgument);
}

}  // namespace
