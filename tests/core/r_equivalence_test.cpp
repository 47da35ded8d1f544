#include "core/r_equivalence.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "core/error.hpp"
#include "core/evaluate.hpp"
#include "core/r_rules.hpp"

namespace rfm {
namespace {

const Field x = x_coordinate(), y = y_coordinate(), z = z_coordinate();

class EveryExponent : public testing::TestWithParam<int> {};
INSTANTIATE_TEST_SUITE_P(REquivalence, EveryExponent, testing::Values(1, 2, 3, 4, 6));

TEST_P(EveryExponent, ValueIsThatOfItsDefinition) {  // eq. (5.3)
  const double p = GetParam();
  const Field joined = equivalence(x, y, GetParam());
  for (const double a : {-2.0, -1e-9, 1e-9, 0.7, 3.0})
    for (const double b : {-2.0, -1e-9, 1e-9, 0.7, 3.0}) {
      const double expected =
          a * b * std::pow(std::pow(std::fabs(a), p) + std::pow(std::fabs(b), p), -1 / p);
      EXPECT_NEAR(value_at(joined, {a, b}), expected, 4e-15 * std::fabs(expected));
    }
}

TEST_P(EveryExponent, NormalisationIsPreservedToOrderPAndNoFurther) {
  // x ~p 2 = x (1 + |x/2|ᵖ)^{−1/p} = x − x|x|ᵖ / (p 2ᵖ) + …
  constexpr int order = 7;
  const int p = GetParam();
  using Number = Jet<double, 1, order>;
  const Number joined = rp_equivalence(Number::variable(0, 0.0), Number(2.0), p);
  EXPECT_EQ(joined.c[0], 0);
  EXPECT_NEAR(joined.c[1], 1, 1e-15);
  for (int k = 2; k <= p; ++k) EXPECT_NEAR(joined.c[k], 0, 1e-15) << k;
  EXPECT_NEAR(joined.c[p + 1], -1 / (p * std::pow(2.0, p)), 1e-15);
}

TEST_P(EveryExponent, IsAssociativeAndCommutative) {
  const int p = GetParam();
  const Field left = equivalence(equivalence(x, y, p), z, p);
  const Field right = equivalence(x, equivalence(y, z, p), p);
  const Field turned = equivalence({z, x, y}, p);
  for (const Point& point : {Point{1, 2, 3}, Point{-0.1, 5, 0.2}, Point{1e-9, -3, -2}}) {
    const double expected = value_at(left, point);
    EXPECT_NEAR(value_at(right, point), expected, 4e-15 * std::fabs(expected));
    EXPECT_NEAR(value_at(turned, point), expected, 4e-15 * std::fabs(expected));
  }
}

TEST_P(EveryExponent, KeepsItsDigitsWhereOneArgumentIsTiny) {
  const Field joined = equivalence(x, y, GetParam());
  for (const double a : {1e-300, 1e-120, 1e-30}) {
    EXPECT_NEAR(value_at(joined, {a, 4}), a, 1e-15 * a);
    EXPECT_NEAR(value_at(joined, {a, -a}), -a * std::pow(2, -1.0 / GetParam()), 2e-15 * a);
  }
}

// 300 fields of one line each against the closed form [Σ ωᵢ⁻ᵖ]^(−1/p) in long double.
TEST_P(EveryExponent, OfManyIsTheClosedFormToAFewUnitsInTheLastPlace) {
  const int p = GetParam();
  std::vector<Field> fields;
  for (int i = 0; i < 300; ++i) fields.push_back(1 + 0.01 * i + x * (i % 7));
  const Field joined = equivalence(fields, p);
  for (const double at : {0.0, 0.3, 2.0}) {
    long double sum = 0;
    for (int i = 0; i < 300; ++i) sum += std::pow(1.0L + 0.01L * i + at * (i % 7), -1.0L * p);
    const double expected = static_cast<double>(std::pow(sum, -1.0L / p));
    EXPECT_NEAR(value_at(joined, {at}), expected, 3e-15 * expected);
  }
  // Where one of them is zero: its slope.
  fields[150] = x;
  EXPECT_NEAR(evaluate(equivalence(fields, p), {0, 0}, 1, 2).derivative(1, 0), 1, 1e-14);
}

TEST(REquivalence, IsZeroWithFiniteDerivativesWhereBothAre) {
  const PointJet corner = evaluate(equivalence(x, y, 2), {0, 0}, 2, 2);
  EXPECT_EQ(corner.value(), 0);
  for (int i = 0; i <= 2; ++i)
    for (int j = 0; i + j <= 2; ++j) EXPECT_TRUE(std::isfinite(corner.derivative(i, j)));
}

TEST(REquivalence, NeedsAWholeExponentAndFields) {
  EXPECT_THROW(equivalence(x, y, 0), InvalidArgument);
  EXPECT_THROW(equivalence(x, y, 65), InvalidArgument);
  EXPECT_THROW(equivalence(std::vector<Field>{}, 2), InvalidArgument);
}

}  // namespace
}  // namespace rfm
