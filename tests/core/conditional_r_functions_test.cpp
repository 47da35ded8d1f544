#include "core/conditional_r_functions.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "core/evaluate.hpp"
#include "core/r_functions.hpp"

namespace rfm {
namespace {

const Field x = x_coordinate(), y = y_coordinate(), z = z_coordinate();
constexpr double places[] = {-2, -1e-3, 1e-3, 0.7, 3};

TEST(ConditionalRFunctions, AreR0WhereTheirTermVanishes) {
  for (const double a : places)
    for (const double b : places) {
      EXPECT_NEAR(value_at(conditional_conjunction(x, y, 0.0), {a, b}),
                  value_at(conjunction(x, y), {a, b}), 1e-15);
      EXPECT_NEAR(value_at(conditional_disjunction(x, y, 0.0), {a, b}),
                  value_at(disjunction(x, y), {a, b}), 1e-15);
    }
}

TEST(ConditionalRFunctions, AreSmoothAtTheCornerWhereItDoesNot) {
  // On a sphere about the corner x = y = 0 the gradient is the same to first order in its radius.
  const Field f = conditional_conjunction(x, y, 0.25);
  for (int k = 0; k < 16; ++k) {
    const double t = 0.1 + k * 0.3927, r = 1e-6;
    const PointJet jet = evaluate(f, {r * std::cos(t), r * std::sin(t)}, 2, 2);
    EXPECT_NEAR(jet.value(), -0.5, 1e-5);
    EXPECT_NEAR(jet.derivative(1, 0), 1, 1e-5);
    EXPECT_NEAR(jet.derivative(2, 0), -2, 1e-5);  // −1/√s
    EXPECT_NEAR(jet.derivative(1, 1), 0, 1e-5);
  }
}

TEST(ConditionalRFunctions, HaveTheZeroSetTheySay) {
  // {2xy = s} inside the conjunction, here with s = 2 z².
  const Field f = conditional_conjunction(x, y, 2 * z * z);
  for (const double a : {0.3, 1.0, 4.0}) EXPECT_NEAR(value_at(f, {a, 0.25 / a, 0.5}), 0, 1e-16);
  EXPECT_LT(value_at(f, {0.4, 0.4, 0.5}), 0);
  EXPECT_GT(value_at(f, {0.6, 0.6, 0.5}), 0);
}

TEST(QuotientConjunction, IsAConjunctionUnlessBothAreNegative) {
  const Field f = quotient_conjunction(x, y);
  for (const double a : places)
    for (const double b : places) {
      const double value = value_at(f, {a, b});
      if (a > 0 || b > 0) {
        EXPECT_EQ(value > 0, a > 0 && b > 0);
      } else {
        EXPECT_GT(value, 0);  // the condition is needed
      }
    }
}

TEST(QuotientConjunction, IsNormalizedToOrderTwo) {
  const PointJet jet = evaluate(quotient_conjunction(x, y), {0, 0.8}, 3, 2);
  EXPECT_NEAR(jet.derivative(1, 0), 1, 1e-15);
  EXPECT_NEAR(jet.derivative(2, 0), 0, 1e-14);
  EXPECT_NEAR(jet.derivative(3, 0), -3 / 0.64, 1e-13);
}

}  // namespace
}  // namespace rfm
