#include "core/field.hpp"

#include <gmock/gmock.h>

#include <cmath>

#include "core/error.hpp"
#include "core/evaluate.hpp"
#include "core/tape.hpp"

namespace rfm {
namespace {

const Field x = x_coordinate(), y = y_coordinate(), z = z_coordinate();

TEST(Field, ConstantsFold) {
  const Field four = Field(1.0) + sqrt(Field(9.0));
  EXPECT_TRUE(four.is_constant(4));
  EXPECT_EQ(four.constant(), 4);
  EXPECT_TRUE(select(1.0, four, x).is_constant(4));
  EXPECT_THROW(x.constant(), InvalidArgument);
}

TEST(Field, UndefinedConstantsAreLeftToEvaluation) {
  const Field undefined = sqrt(Field(-1.0));
  EXPECT_FALSE(undefined.is_constant());
  EXPECT_TRUE(std::isnan(value_at(undefined, {})));
}

TEST(Field, NeutralElementsDisappear) {
  EXPECT_TRUE((x + 0.0).same_as(x));
  EXPECT_TRUE((0.0 + x).same_as(x));
  EXPECT_TRUE((x - 0.0).same_as(x));
  EXPECT_TRUE((1.0 * x).same_as(x));
  EXPECT_TRUE((x / 1.0).same_as(x));
  EXPECT_TRUE((-(-x)).same_as(x));
  EXPECT_TRUE(pow(x, 1.0).same_as(x));
  EXPECT_TRUE((x * 0.0).is_constant(0));
  EXPECT_TRUE(pow(x, 0.0).is_constant(1));
}

TEST(Field, ProductsWithZeroVanishOnlyWhereBothFactorsAreDefined) {
  const Field x = x_coordinate(), y = y_coordinate();
  for (const Field& f : {sin(x), hypot(x, y), x / 2, pow(x, 3.0), pow(x, 77.0), partial(erf(x), 0)})
    EXPECT_TRUE((0 * f).is_constant(0));
  for (const Field& f :
       {log(x), sqrt(x), asin(x), x / y, pow(x, -1.0), pow(x, 0.5), pow(x, y), mod(x, y), tan(x)}) {
    EXPECT_FALSE((0 * f).is_constant());
    EXPECT_FALSE((sin(f) * 0).is_constant());
    EXPECT_TRUE(product_or_nothing(0, f).is_constant(0));
  }
  EXPECT_FALSE((0 / x).is_constant());
  EXPECT_TRUE(std::isnan(value_at(0 / x, {0, 0})));
  EXPECT_TRUE(std::isnan(value_at(0 * log(x), {-1, 0})));
  EXPECT_EQ(value_at(0 * log(x), {2, 0}), 0);
}

TEST(Field, SelectLooksAtTheChosenBranchOnly) {
  const Field safe = select(x, 1 / x, 7.0);
  EXPECT_EQ(value_at(safe, {0}), 7);
  EXPECT_EQ(value_at(safe, {4}), 0.25);
  EXPECT_EQ(evaluate(safe, {0}, 2).derivative(2), 0);
}

TEST(Field, PowersFollowTheKindOfTheirExponent) {
  EXPECT_EQ(value_at(pow(x, 3), {-2}), -8);  // exact products also for negative bases
  EXPECT_EQ(value_at(pow(x, -2), {-2}), 0.25);
  EXPECT_EQ(evaluate(pow(x, 3), {-2}, 3).derivative(3), 6);
  EXPECT_NEAR(value_at(pow(x, 2.5), {4}), 32, 1e-14);
  EXPECT_TRUE(std::isnan(value_at(pow(x, 2.5), {-4})));
  EXPECT_NEAR(value_at(pow(x, y), {3, 4}), 81, 1e-12);
  // ∂/∂y xʸ = xʸ log x
  EXPECT_NEAR(evaluate(pow(x, y), {3, 4}, 1).derivative(0, 1), 81 * std::log(3), 1e-11);
  EXPECT_EQ(evaluate(pow(x, y), {0, 2}, 1).derivative(1, 0), 0);
}

TEST(Field, ModHasTheSignOfTheDivisor) {
  EXPECT_EQ(value_at(mod(x, y), {-7, 3}), 2);
  EXPECT_EQ(value_at(mod(x, y), {7, -3}), -2);
  EXPECT_EQ(value_at(mod(x, y), {49, 49}), 0);
}

TEST(Field, PartialDerivativesOfLeavesAreKnown) {
  EXPECT_TRUE(partial(x, 0).is_constant(1));
  EXPECT_TRUE(partial(x, 1).is_constant(0));
  EXPECT_TRUE(partial(parameter(2), 0).is_constant(0));
  EXPECT_TRUE(partial(time_coordinate(), 0).is_constant(0));
  EXPECT_THROW(partial(x, -1), InvalidArgument);
}

TEST(Field, LaplacianOfAHarmonicFunctionVanishes) {
  const Field harmonic = exp(x) * sin(y) + log(x * x + y * y);
  EXPECT_NEAR(value_at(laplacian(harmonic, 2), {0.7, -0.4}), 0, 1e-14);
  EXPECT_NEAR(value_at(laplacian(1 / sqrt(x * x + y * y + z * z), 3), {0.7, -0.4, 0.2}), 0, 1e-13);
}

TEST(Field, InwardDerivativeIsTheScalarProductOfGradients) {
  const Field f = x * x * y, omega = 3 * x - y;
  EXPECT_NEAR(value_at(inward_derivative(f, omega, 2), {2, 5}), 3 * 2 * 2 * 5 - 4, 1e-14);
}

TEST(Field, NormalizedFunctionsHaveUnitSlopeOnTheirZeroSet) {
  const Field f = normalize(x * x / 4 + y * y - 1, 2);
  for (double angle = 0; angle < 6.28; angle += 0.3) {
    const PointJet jet = evaluate(f, {2 * std::cos(angle), std::sin(angle)}, 1);
    EXPECT_NEAR(jet.value(), 0, 1e-15);
    EXPECT_NEAR(std::hypot(jet.derivative(1, 0), jet.derivative(0, 1)), 1, 1e-14);
  }
}

TEST(Field, GenericLambdasAreFields) {
  const Field f = field([](auto a, auto b) { return sin(a) * exp(b); });
  EXPECT_NEAR(value_at(f, {0.3, 0.2}), std::sin(0.3) * std::exp(0.2), 1e-16);
  EXPECT_EQ(value_at(field([](auto a) { return a + 1; }), {2}), 3);
  EXPECT_EQ(value_at(field([](auto a, auto b, auto c) { return a * b * c; }), {2, 3, 5}), 30);
}

TEST(Field, ChainsOfAMillionNodesAreDestroyedWithoutRecursion) {
  // A stack of 8 MB holds some 100,000 calls of a destructor.
  Field chain = x;
  for (int i = 0; i < 1000000; ++i) chain = sin(chain);
  EXPECT_FALSE(chain.is_constant());
}

TEST(Field, ChainsThatUseAnArgumentTwiceAreDestroyedWithoutRecursion) {
  Field square = x, length = y;
  for (int i = 0; i < 300000; ++i) square = square * square, length = hypot(length, length);
  EXPECT_FALSE(square.is_constant() || length.is_constant());
}

TEST(Field, WrongBuildersAreRefused) {
  EXPECT_THROW(apply(Operation::sin, {x, y}), InvalidArgument);
  EXPECT_THROW(apply(Operation::coordinate, {}), InvalidArgument);
  EXPECT_THROW(coordinate(4), InvalidArgument);
  EXPECT_THROW(parameter(-1), InvalidArgument);
  EXPECT_THROW(field(std::shared_ptr<const FieldSource>()), InvalidArgument);
}

TEST(Powers, WithANumberAsExponentAreTheSameHoweverTheyAreMade) {
  const Field x = x_coordinate();
  for (const double exponent : {2.0, 3.0, -1.0, 0.0, 1.0, 0.5, -2.5, 65.0}) {
    const Field f = apply(Operation::power, {x, exponent}), same = pow(x, exponent);
    for (const double at : {-1.5, -0.0, 0.0, 0.3, 2.0}) {
      const double value = value_at(f, {at}), expected = value_at(same, {at});
      EXPECT_TRUE(value == expected || (std::isnan(value) && std::isnan(expected)))
          << at << "^" << exponent << ": " << value << ", not " << expected;
    }
  }
  EXPECT_EQ(value_at(apply(Operation::power, {x, 2.0}), {-3}), 9);
  EXPECT_TRUE(apply(Operation::integer_power, {x}, 0).is_constant(1));
  EXPECT_EQ(apply(Operation::power, {-3.0, 2.0}).constant(), 9);
  // No number: as it is.
  EXPECT_EQ(value_at(apply(Operation::power, {x, INFINITY}), {2}), INFINITY);
  EXPECT_EQ(value_at(pow(x, INFINITY), {0.5}), 0);
}

}  // namespace
}  // namespace rfm
