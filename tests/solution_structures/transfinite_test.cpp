#include "solution_structures/transfinite.hpp"

#include <gmock/gmock.h>

#include <cmath>

#include "core/error.hpp"
#include "core/evaluate.hpp"

namespace rfm {
namespace {

const Field x = x_coordinate(), y = y_coordinate();

// Three disjoint sets: the line x = 0, the line x = 1, and the point (1/2, 1/2).
const Field to_left = x, to_right = 1 - x, to_point = sqrt(pow(x - 0.5, 2) + pow(y - 0.5, 2));
// Data that no single smooth function would give.
const Field left = sin(3 * y), right = exp(x) * y * y - 2, middle = 5 + x;

Field interpolant(int exponent) {
  return transfinite_interpolant(
      {{left, to_left, exponent}, {right, to_right, exponent}, {middle, to_point, exponent}});
}

class EveryExponent : public testing::TestWithParam<int> {};
INSTANTIATE_TEST_SUITE_P(Transfinite, EveryExponent, testing::Values(1, 2, 3));

TEST_P(EveryExponent, InterpolantEqualsEachDatumOnItsSet) {
  const Field u = interpolant(GetParam());
  for (const double b : {-0.7, 0.1, 0.5, 1.3}) {
    EXPECT_NEAR(value_at(u, {0, b}), std::sin(3 * b), 1e-15);
    EXPECT_NEAR(value_at(u, {1, b}), std::exp(1) * b * b - 2, 2e-15);
  }
  EXPECT_NEAR(value_at(u, {0.5, 0.5}), 5.5, 1e-15);
}

TEST_P(EveryExponent, DerivativesUpToTheExponentAreThoseOfTheDatum) {
  const int exponent = GetParam();
  const Field u = interpolant(exponent);
  for (const double b : {-0.7, 0.3, 1.3}) {
    const PointJet jet = evaluate(u, {1, b}, 3, 2), datum = evaluate(right, {1, b}, 3, 2);
    for (int k = 0; k < exponent; ++k)
      EXPECT_NEAR(jet.derivative(k), datum.derivative(k), 1e-12) << k << " at y = " << b;
    // And no further: this would be a formula that reproduces its data everywhere.
    EXPECT_GT(std::fabs(jet.derivative(exponent) - datum.derivative(exponent)), 1e-2);
  }
}

TEST_P(EveryExponent, ValuesStayBetweenThoseOfTheData) {
  const Field u = interpolant(GetParam());
  for (double a = 0.05; a < 1; a += 0.09)
    for (double b = -0.5; b < 1.5; b += 0.11) {
      const double values[] = {value_at(left, {a, b}), value_at(right, {a, b}),
                               value_at(middle, {a, b})};
      EXPECT_GE(value_at(u, {a, b}), *std::ranges::min_element(values) - 1e-14);
      EXPECT_LE(value_at(u, {a, b}), *std::ranges::max_element(values) + 1e-14);
    }
}

TEST(Transfinite, IsFiniteWithItsDerivativesOnTheSets) {
  for (const Point& at : {Point{0, 0.2}, Point{1, 0.2}, Point{0.5, 0.5}}) {
    const PointJet jet = evaluate(interpolant(2), at, 2, 2);
    for (int i = 0; i <= 2; ++i)
      for (int j = 0; i + j <= 2; ++j) EXPECT_TRUE(std::isfinite(jet.derivative(i, j)));
  }
}

TEST(Transfinite, ExponentsMayDifferFromSetToSet) {
  // ∂/∂x of the datum is taken on x = 1, where μ = 2, and not on x = 0, where μ = 1.
  const Field u = transfinite_interpolant({{left, to_left, 1}, {right, to_right, 2}});
  EXPECT_NEAR(evaluate(u, {1, 0.3}, 1, 2).derivative(1), std::exp(1) * 0.09, 1e-14);
  EXPECT_GT(std::fabs(evaluate(u, {0, 0.3}, 1, 2).derivative(1)), 0.1);
}

TEST(Transfinite, OneDatumIsReturned) {
  EXPECT_TRUE(transfinite_interpolant({{left, to_left, 2}}).same_as(left));
}

TEST(Transfinite, EqualDataAreReproducedEverywhere) {
  const Field u = transfinite_interpolant({{left, to_left, 1}, {left, to_right, 1}});
  EXPECT_NEAR(value_at(u, {0.37, 0.8}), std::sin(2.4), 1e-15);
}

TEST(Transfinite, NoDataAreRefused) { EXPECT_THROW(transfinite_interpolant({}), InvalidArgument); }

}  // namespace
}  // namespace rfm
