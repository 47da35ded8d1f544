#include "core/trim.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "core/evaluate.hpp"

namespace rfm {
namespace {

// γ = y, λ = x: the positive half of the x axis.
const Field x = x_coordinate(), y = y_coordinate();
const Field half_line = trim(y, x), from_inside = trim_from_inside(y, x);

long double formula(long double gamma, long double lambda) {  // eq. (5.1)
  const long double rest = std::sqrt(lambda * lambda + std::pow(gamma, 4.0L)) - lambda;
  return std::sqrt(gamma * gamma + rest * rest / 4);
}

TEST(Trim, ValueIsThatOfItsFormulaOnBothSides) {
  for (const double lambda : {-3.0, -1e-3, -1e-12, 0.0, 1e-12, 1e-3, 0.4, 2.0})
    for (const double gamma : {-1.5, -0.1, -1e-6, 1e-6, 0.2, 3.0}) {
      const double expected = static_cast<double>(formula(gamma, lambda));
      EXPECT_NEAR(value_at(half_line, {lambda, gamma}), expected, 4e-15 * expected)
          << lambda << ", " << gamma;
    }
}

TEST(Trim, VanishesOnTheHalfLineAloneWithUnitSlope) {
  for (const double a : {0.0, 0.3, 2.0}) EXPECT_EQ(value_at(half_line, {a, 0}), 0);
  for (const double a : {-1e-9, -0.3, -2.0})
    EXPECT_NEAR(value_at(half_line, {a, 0}), std::fabs(a), 1e-15);  // √(λ²) − λ over 2
  for (double angle = 0.1; angle < 6.2; angle += 0.1)
    for (const double r : {1e-6, 0.1, 1.0, 10.0})
      EXPECT_GT(value_at(half_line, {r * std::cos(angle), r * std::sin(angle)}), 0);
  for (const double a : {0.3, 2.0}) {
    EXPECT_NEAR(evaluate(half_line, {a, 1e-9}, 1).derivative(0, 1), 1, 1e-15);
    EXPECT_NEAR(evaluate(half_line, {a, -1e-9}, 1).derivative(0, 1), -1, 1e-15);
    EXPECT_NEAR(evaluate(half_line, {a, 1e-9}, 1).derivative(1, 0), 0, 1e-15);
  }
}

TEST(Trim, IsZeroExactlyOnThePart) {
  EXPECT_EQ(value_at(half_line, {2, 0}), 0);
  EXPECT_EQ(value_at(half_line, {0, 0}), 0);
  EXPECT_EQ(value_at(half_line, {-2, 0}), 2);  // the distance from the end
  EXPECT_GT(value_at(half_line, {2, 1e-150}), 0);
  EXPECT_GT(value_at(half_line, {-1e-150, 0}), 0);
}

TEST(Trim, IsNormalisedOnThePart) {
  // |γ| √(1 + γ⁶ / (16 λ²) + …): on γ = 0 the first derivative is 1, those up to the sixth vanish.
  for (const double lambda : {1e-3, 0.5, 20.0}) {
    const PointJet on = evaluate(half_line, {lambda, 0}, 4, 2);
    EXPECT_EQ(on.derivative(0, 1), 1) << lambda;
    for (int k = 2; k <= 4; ++k) EXPECT_EQ(on.derivative(0, k), 0) << lambda << ", order " << k;
    for (int k = 1; k <= 4; ++k) EXPECT_EQ(on.derivative(k, 0), 0) << lambda << ", order " << k;
  }
}

TEST(Trim, FromInsideHasTheSameDerivativesWhereverRoundingPutsThePoint) {
  for (const double gamma : {-1e-16, 0.0, 1e-16}) {
    const PointJet jet = evaluate(from_inside, {0.7, gamma}, 2, 2);
    EXPECT_EQ(jet.value(), gamma);
    EXPECT_EQ(jet.derivative(0, 1), 1);
    EXPECT_NEAR(jet.derivative(0, 2), 0, 1e-60);
  }
  EXPECT_EQ(evaluate(half_line, {0.7, -1e-16}, 1, 2).derivative(0, 1), -1);
  EXPECT_EQ(value_at(from_inside, {-2, 0}), 2);
}

TEST(Trim, IsFiniteWithItsDerivativesAtTheEnd) {
  const PointJet end = evaluate(half_line, {0, 0}, 2);
  for (int i = 0; i <= 2; ++i)
    for (int j = 0; i + j <= 2; ++j) EXPECT_TRUE(std::isfinite(end.derivative(i, j)));
}

TEST(Trim, IsTwiceDifferentiableAcrossTheBoundaryOfLambda) {
  for (const double gamma : {0.3, 1.0}) {
    const PointJet left = evaluate(half_line, {-1e-9, gamma}, 2, 2);
    const PointJet right = evaluate(half_line, {1e-9, gamma}, 2, 2);
    for (int i = 0; i <= 2; ++i)
      for (int j = 0; i + j <= 2; ++j)
        EXPECT_NEAR(left.derivative(i, j), right.derivative(i, j), 1e-6) << i << j;
  }
}

}  // namespace
}  // namespace rfm
