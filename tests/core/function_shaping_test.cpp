#include "core/function_shaping.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "core/error.hpp"
#include "core/evaluate.hpp"

namespace rfm {
namespace {

const Field x = x_coordinate();

TEST(Saturate, KeepsNormalizationToTheOrderOfAlpha) {
  for (const int alpha : {1, 2, 3, 4, 6}) {
    const PointJet jet = evaluate(saturate(x, {double(alpha), 1.5}), {0}, alpha + 1, 1);
    EXPECT_NEAR(jet.value(), 0, 1e-15);
    EXPECT_NEAR(jet.derivative(1), 1, 1e-15);
    for (int k = 2; k <= alpha; ++k) EXPECT_NEAR(jet.derivative(k), 0, 1e-13) << alpha;
    // x (1 − (βx)^α + …): and no further.
    EXPECT_NEAR(jet.derivative(alpha + 1), -std::tgamma(alpha + 2) * std::pow(1.5, alpha), 1e-9)
        << alpha;
  }
}

TEST(Saturate, IsOddAndBounded) {
  for (const double alpha : {1.0, 2.0, 2.5, 3.0}) {
    const Field f = saturate(x, {alpha, 2});
    const double largest =
        alpha == 1 ? 0.5 : 0.5 * std::pow(alpha - 1, -1 / alpha) * (alpha - 1) / alpha;
    for (double at = 0.01; at < 100; at *= 1.7) {
      EXPECT_GT(value_at(f, {at}), 0);
      EXPECT_LE(value_at(f, {at}), largest * (1 + 1e-14)) << alpha;
      EXPECT_EQ(value_at(f, {-at}), -value_at(f, {at}));
    }
  }
}

TEST(LevelOff, IsNormalizedToOrderTwoAndTendsToTheLength) {
  const PointJet jet = evaluate(level_off(x, 2), {0}, 3, 1);
  EXPECT_EQ(jet.value(), 0);
  EXPECT_EQ(jet.derivative(1), 1);
  EXPECT_EQ(jet.derivative(2), 0);
  EXPECT_DOUBLE_EQ(jet.derivative(3), -3.0 / 4);  // x − x³/2L² + …
  EXPECT_NEAR(value_at(level_off(x, 2), {1e9}), 2, 1e-15);
  EXPECT_EQ(value_at(level_off(x, 2), {-3}), -value_at(level_off(x, 2), {3}));
  EXPECT_THROW(level_off(x, 0), InvalidArgument);
}

TEST(Cutoff, IsOneOnTheBoundaryToOrderThreeAndNothingFurtherInside) {
  const PointJet jet = evaluate(cutoff(x, 0.5), {0}, 4, 1);
  EXPECT_EQ(jet.value(), 1);
  for (int k = 1; k <= 3; ++k) EXPECT_EQ(jet.derivative(k), 0);
  EXPECT_NEAR(jet.derivative(4), -24 * 16, 1e-12);
  EXPECT_LT(value_at(cutoff(x, 0.5), {1.1}), 1e-10);
  EXPECT_THROW(cutoff(x, 0), InvalidArgument);
}

TEST(Cap, IsBelowBothAndNormalized) {
  const Field f = cap(x, 0.3);
  for (double at = 0.01; at < 100; at *= 1.7) EXPECT_LT(value_at(f, {at}), std::min(at, 0.3));
  EXPECT_NEAR(evaluate(f, {0}, 1, 1).derivative(1), 1, 1e-15);
}

TEST(Plateau, IsSmoothToItsOrderAtTheEdge) {
  for (const int power : {1, 2, 3, 5}) {
    const Field f = plateau(x, {0.5, power});
    EXPECT_NEAR(evaluate(f, {0}, 1, 1).derivative(1), 2 * power, 1e-14);
    EXPECT_EQ(value_at(f, {0.7}), 1);
    const double h = 1e-11;
    const PointJet below = evaluate(f, {0.5 - h}, power, 1),
                   above = evaluate(f, {0.5 + h}, power, 1);
    for (int k = 0; k < power; ++k)
      EXPECT_NEAR(below.derivative(k), above.derivative(k), 1e-6) << power << ", " << k;
    EXPECT_GT(std::fabs(below.derivative(power) - above.derivative(power)), 0.5);
  }
}

TEST(FunctionShaping, RefusesParametersOutOfRange) {
  EXPECT_THROW(saturate(x, {0.5, 1}), InvalidArgument);
  EXPECT_THROW(saturate(x, {2, 0}), InvalidArgument);
  EXPECT_THROW(plateau(x, {0, 3}), InvalidArgument);
  EXPECT_THROW(plateau(x, {1, 0}), InvalidArgument);
  EXPECT_THROW(plateau(x, {1, 17}), InvalidArgument);
}

}  // namespace
}  // namespace rfm
