#include "core/r_functions.hpp"

#include <gmock/gmock.h>

#include <cmath>

#include "core/error.hpp"
#include "core/evaluate.hpp"
#include "core/primitives.hpp"

namespace rfm {

namespace {

const Field x = x_coordinate(), y = y_coordinate();

// Failures name the system.
std::string name_of(const testing::TestParamInfo<RSystem>& info) {
  if (const auto* system = std::get_if<Rp>(&info.param)) return "Rp" + std::to_string(system->p);
  const double alpha = std::get<RAlpha>(info.param).alpha;
  return std::string("RAlpha") + (alpha < 0 ? "Minus" : "") +
         std::to_string(static_cast<int>(std::fabs(100 * alpha))) + "Percent";
}

class EverySystem : public testing::TestWithParam<RSystem> {};
INSTANTIATE_TEST_SUITE_P(RFunctions, EverySystem,
                         testing::Values(RAlpha{-0.9}, RAlpha{0}, RAlpha{0.5}, RAlpha{1}, Rp{2},
                                         Rp{4}, Rp{6}),
                         name_of);
class EveryAlpha : public testing::TestWithParam<double> {};
INSTANTIATE_TEST_SUITE_P(RFunctions, EveryAlpha, testing::Values(-0.5, 0.0, 0.3, 0.9, 1.0));

constexpr double places[] = {-2.0, -1e-9, 1e-9, 0.7, 3.0};

TEST_P(EverySystem, ConjunctionIsPositiveExactlyWhereBothArgumentsAre) {
  const Field both = conjunction(x, y, GetParam());
  for (const double a : {-2.0, -1e-9, 1e-9, 3.0})
    for (const double b : {-2.0, -1e-9, 1e-9, 3.0})
      EXPECT_EQ(value_at(both, {a, b}) > 0, a > 0 && b > 0) << "at " << a << ", " << b;
}

TEST_P(EverySystem, DisjunctionIsPositiveExactlyWhereAnyArgumentIs) {
  const Field either = disjunction(x, y, GetParam());
  for (const double a : {-2.0, -1e-9, 1e-9, 3.0})
    for (const double b : {-2.0, -1e-9, 1e-9, 3.0})
      EXPECT_EQ(value_at(either, {a, b}) > 0, a > 0 || b > 0) << "at " << a << ", " << b;
}

TEST_P(EverySystem, ConjunctionIsNormalizedOnItsFace) {
  // On {x = 0, y > 0}: x ∧ y = x + O(x²), so ∂/∂x = 1 and ∂/∂y = 0.
  const PointJet omega = evaluate(conjunction(x, y, GetParam()), {0.0, 2.0}, 1);
  EXPECT_NEAR(omega.derivative(1, 0), 1.0, 1e-14);
  EXPECT_NEAR(omega.derivative(0, 1), 0.0, 1e-14);
}

TEST_P(EverySystem, DeMorgansLawAndCommutativityHold) {
  const Field law = disjunction(x, y, GetParam()) + conjunction(-x, -y, GetParam());
  const Field commuted = conjunction(x, y, GetParam()) - conjunction(y, x, GetParam());
  for (const double a : places)
    for (const double b : places) {
      EXPECT_NEAR(value_at(law, {a, b}), 0, 1e-15);
      EXPECT_NEAR(value_at(commuted, {a, b}), 0, 1e-15);
    }
}

TEST_P(EverySystem, DerivativesAreFiniteAtTheCorner) {
  for (const Field& f : {conjunction(x, y, GetParam()), disjunction(x, y, GetParam())}) {
    const PointJet jet = evaluate(f, {0, 0}, 2);
    EXPECT_EQ(jet.value(), 0);
    for (int i = 0; i <= 2; ++i)
      for (int j = 0; i + j <= 2; ++j) EXPECT_TRUE(std::isfinite(jet.derivative(i, j)));
  }
}

TEST_P(EveryAlpha, SumAndProductOfConjunctionAndDisjunctionAreRational) {
  // (x ∧ y) + (x ∨ y) = 2 (x + y) / (1 + α) and (x ∧ y)(x ∨ y) = 2 x y / (1 + α).
  const double alpha = GetParam();
  const Field both = conjunction(x, y, RAlpha{alpha}), either = disjunction(x, y, RAlpha{alpha});
  for (const double a : places)
    for (const double b : places) {
      EXPECT_NEAR(value_at(both + either, {a, b}), 2 * (a + b) / (1 + alpha), 2e-14);
      EXPECT_NEAR(value_at(both * either, {a, b}), 2 * a * b / (1 + alpha), 5e-14);
    }
}

TEST_P(EveryAlpha, ConjunctionKeepsItsDigitsNextToTheBoundary) {
  // On y = 1: x ∧ 1 = x − (1 − α) x² / 2 + O(x³) for α < 1 and x for α = 1.
  const double alpha = GetParam();
  const Field both = conjunction(x, y, RAlpha{alpha});
  for (const double a : {1e-12, 1e-40}) {
    const double expected = a - 0.5 * (1 - alpha) * a * a;
    EXPECT_NEAR(value_at(both, {a, 1}), expected, 1e-15 * a);
    EXPECT_NEAR(value_at(disjunction(x, y, RAlpha{alpha}), {-a, -1}), -expected, 1e-15 * a);
  }
}

TEST(RFunctions, RpIsNormalizedToOrderPMinusOne) {
  // x ∧ y = x + O(xᵖ): all pure derivatives along x from the second to order p − 1 vanish on x = 0,
  // and the p-th is not zero.
  const PointJet four = evaluate(conjunction(x, y, Rp{4}), {0.0, 2.0}, 4, 2);
  EXPECT_DOUBLE_EQ(four.derivative(1), 1);
  EXPECT_NEAR(four.derivative(2), 0, 1e-14);
  EXPECT_NEAR(four.derivative(3), 0, 1e-14);
  // (x⁴ + 16)^{1/4} = 2 + x⁴ / 32 + O(x⁸)
  EXPECT_NEAR(four.derivative(4), -24.0 / 32, 1e-13);
  EXPECT_NEAR(evaluate(conjunction(x, y, Rp{2}), {0.0, 2.0}, 2, 2).derivative(2), -0.5, 1e-14);
}

TEST(RFunctions, ParametersOutOfRangeAreRefused) {
  EXPECT_THROW(conjunction(x, y, RAlpha{-1}), InvalidArgument);  // −1 < α ≤ 1
  EXPECT_THROW(conjunction(x, y, RAlpha{1.01}), InvalidArgument);
  EXPECT_THROW(conjunction(x, y, RAlpha{std::nan("")}), InvalidArgument);
  EXPECT_THROW(disjunction(x, y, RAlpha{-1}), InvalidArgument);
  EXPECT_THROW(conjunction(x, y, Rp{3}), InvalidArgument);
  EXPECT_THROW(conjunction(x, y, Rp{0}), InvalidArgument);
}

TEST_P(EverySystem, ImplicitFunctionOfARegionHasItsSign) {
  const Region region = (box({-1, -1}, {1, 1}) - circle({1, 1}, 0.8)) | circle({-1, 0}, 0.5);
  const RegionEvaluator evaluator(region);
  const Field omega = implicit(region, GetParam());
  for (double a = -1.63; a < 1.6; a += 0.11)
    for (double b = -1.617; b < 1.6; b += 0.11)
      EXPECT_EQ(value_at(omega, {a, b}) > 0, evaluator.contains(Point{a, b})) << a << ", " << b;
}

}  // namespace
}  // namespace rfm
