#include "core/dynamic_jet.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <random>

#include "core/error.hpp"
#include "tests/core/operation_rows.hpp"

namespace rfm {
namespace {

using Number = DynamicJet<double>;

Number random_jet(const JetShape& shape, double value) {
  static std::mt19937 generator(1);
  std::uniform_real_distribution<double> uniform(-1, 1);
  Number jet(shape);
  for (double& coefficient : jet.c) coefficient = uniform(generator);
  jet.c[0] = value;
  return jet;
}

// Largest difference of coefficients, relative to the largest one.
double difference(const Number& a, const Number& b) {
  double largest = 1, difference = 0;
  for (int i = 0; i < std::max(a.size, b.size); ++i) {
    const double left = coefficient(a, i), right = coefficient(b, i);
    largest = std::max(largest, std::fabs(right));
    if (!(std::fabs(left - right) <= difference)) difference = std::fabs(left - right);
  }
  return difference / largest;
}

struct Shape {
  int variables, order;
  friend void PrintTo(const Shape& shape, std::ostream* out) {
    *out << shape.order << " in " << shape.variables;
  }
};

class JetsOfOrder : public testing::TestWithParam<Shape> {
 protected:
  const JetShape& shape = JetShape::get(GetParam().variables, GetParam().order);
};
INSTANTIATE_TEST_SUITE_P(Dynamic, JetsOfOrder,
                         testing::Values(Shape{1, 16}, Shape{2, 0}, Shape{2, 1}, Shape{2, 8},
                                         Shape{3, 6}, Shape{3, 8}, Shape{4, 1}, Shape{4, 2},
                                         Shape{4, 8}));

TEST_P(JetsOfOrder, FormARing) {
  const Number a = random_jet(shape, 1.3), b = random_jet(shape, -0.6), c = random_jet(shape, 0.7);
  EXPECT_LE(difference(a * b, b * a), 1e-14);
  EXPECT_LE(difference((a * b) * c, a * (b * c)), 1e-13);
  EXPECT_LE(difference((a + b) * c, a * c + b * c), 1e-14);
  EXPECT_EQ(difference(a - a, Number(0.0)), 0);
  EXPECT_EQ(difference(b - a, -(a - b)), 0);
  EXPECT_LE(difference((a / b) * b, a), 1e-9);
}

TEST_P(JetsOfOrder, NumbersCombineAsConstantJets) {
  const Number a = random_jet(shape, 1.3), two(2.0);
  Number same_two(shape);
  same_two.c[0] = 2;
  EXPECT_EQ(difference(a + two, a + same_two), 0);
  EXPECT_EQ(difference(two - a, same_two - a), 0);
  EXPECT_EQ(difference(a - two, a - same_two), 0);
  EXPECT_EQ(difference(a * two, a * same_two), 0);
  EXPECT_EQ(difference(two / a, same_two / a), 0);
  EXPECT_EQ(difference(a / two, a / same_two), 0);
  EXPECT_EQ(difference(select(true, two, a), same_two), 0);
  EXPECT_EQ(difference(max(a, two), same_two), 0);
}

TEST_P(JetsOfOrder, SquaresOfSineAndCosineSumToOne) {
  for (const double value : {-2.3, -0.4, 0.9}) {
    const Number a = random_jet(shape, value), one(1.0);
    const Number sine = sin(a) * sin(a), hyperbolic = sinh(a) * sinh(a);
    EXPECT_LE(difference(sine + cos(a) * cos(a) - one + sine, sine), 1e-13);
    EXPECT_LE(difference(cosh(a) * cosh(a) - hyperbolic - one + hyperbolic, hyperbolic), 1e-13);
  }
}

TEST_P(JetsOfOrder, InverseFunctionsInvert) {
  // The tolerance grows with the coefficients of the functions that are composed.
  const double tolerance = 1e-14 * std::pow(4.0, shape.order());
  for (const double value : {0.5, 1.1}) {
    const Number a = random_jet(shape, value);
    EXPECT_LE(difference(exp(log(a)), a), tolerance);
    EXPECT_LE(difference(log(exp(a)), a), tolerance);
    EXPECT_LE(difference(asin(sin(a)), a), 100 * tolerance);
    EXPECT_LE(difference(atan(tan(a)), a), 100 * tolerance);
    EXPECT_LE(difference(asinh(sinh(a)), a), tolerance);
    EXPECT_LE(difference(sqrt(a) * sqrt(a), a), tolerance);
    EXPECT_LE(difference(cbrt(a * a * a), a), 100 * tolerance);
  }
}

TEST_P(JetsOfOrder, DerivativesFollowTheChainRule) {
  const Number a = random_jet(shape, 0.4), b = random_jet(shape, 1.2);
  const int known = shape.order() > 0 ? shape.size(shape.order() - 1) : 0;
  for (int axis = 0; axis < shape.variables(); ++axis) {
    const auto expect_same = [&](const Number& left, const Number& right) {
      for (int i = 0; i < known; ++i)
        EXPECT_NEAR(left.c[i], right.c[i], 1e-11 * (1 + std::fabs(right.c[i]))) << i;
    };
    const Number da = differentiate(a, axis), db = differentiate(b, axis), one(1.0);
    expect_same(differentiate(a * b, axis), da * b + a * db);
    expect_same(differentiate(sin(a), axis), cos(a) * da);
    expect_same(differentiate(atan(a), axis), da / (one + a * a));
    expect_same(differentiate(hypot(a, b), axis), (a * da + b * db) / hypot(a, b));
    expect_same(differentiate(real_power(b, 1.7), axis), scaled(1.7, real_power(b, 0.7)) * db);
    expect_same(differentiate(erf(a), axis),
                scaled(2 / std::sqrt(std::numbers::pi), exp(-(a * a))) * da);
  }
}

TEST(DynamicJet, ExponentialOfSineOfProductHasItsDerivativesToOrderEight) {
  // With g(t) = exp(sin t) and t = x y:  ∂ₓⁱ∂ᵧʲ g = Σₖ C(i,k) j!/(j−k)! x^{j−k} y^{i−k}
  // g^{(i+j−k)}, and g^{(n+1)} = Σₘ C(n,m) cos^{(m)} g^{(n−m)}.
  constexpr int order = 8;
  const double x = 0.7, y = -1.3, t = x * y;
  double binomial[order + 1][order + 1] = {{1}};
  for (int n = 1; n <= order; ++n)
    for (int k = 0; k <= n; ++k)
      binomial[n][k] = (k > 0 ? binomial[n - 1][k - 1] : 0) + binomial[n - 1][k];
  const double cosines[] = {std::cos(t), -std::sin(t), -std::cos(t), std::sin(t)};
  double g[order + 1] = {std::exp(std::sin(t))};
  for (int n = 0; n < order; ++n)
    for (int m = 0; m <= n; ++m) g[n + 1] += binomial[n][m] * cosines[m % 4] * g[n - m];

  const JetShape& shape = JetShape::get(2, order);
  const Number f = exp(sin(Number::variable(shape, 0, x) * Number::variable(shape, 1, y)));
  for (int i = 0; i <= order; ++i)
    for (int j = 0; i + j <= order; ++j) {
      double expected = 0, size = 0, falling = 1;
      for (int k = 0; k <= std::min(i, j); falling *= j - k, ++k) {
        const double term =
            binomial[i][k] * falling * std::pow(x, j - k) * std::pow(y, i - k) * g[i + j - k];
        expected += term;
        size += std::fabs(term);
      }
      const MultiIndex alpha{static_cast<std::uint8_t>(i), static_cast<std::uint8_t>(j)};
      EXPECT_NEAR(f.derivative(alpha), expected, 1e-13 * (1 + size)) << "∂x^" << i << " ∂y^" << j;
    }
}

TEST(DynamicJet, ComposesByTheFormulaOfFaaDiBruno) {
  // exp(eˣ − 1) = Σ Bₙ xⁿ/n! with the numbers of Bell.
  const double bell[] = {1,       1,        2,         5,          15,         52,
                         203,     877,      4140,      21147,      115975,     678570,
                         4213597, 27644437, 190899322, 1382958545, 10480142147};
  const JetShape& shape = JetShape::get(1, 16);
  const Number f = exp(exp(Number::variable(shape, 0, 0)) - Number(1.0));
  for (int n = 0; n <= 16; ++n)
    EXPECT_NEAR(f.derivative({static_cast<std::uint8_t>(n)}), bell[n], 1e-14 * bell[n]);
}

TEST(DynamicJet, CopiesAndMovesKeepFewAndManyCoefficients) {
  for (const int order : {1, 2, 5}) {
    const Number a = random_jet(JetShape::get(3, order), 2);
    Number copy(0.0), assigned = random_jet(JetShape::get(3, 4), 1);
    copy = a;
    assigned = copy;
    EXPECT_EQ(difference(assigned, a), 0);
    const Number moved = std::move(copy);
    assigned = Number(3.0);
    EXPECT_EQ(difference(moved, a), 0);
    EXPECT_EQ(assigned.c.size(), 1);
    EXPECT_EQ(assigned.value(), 3);
  }
}

TEST(JetShape, RefusesWhatHasNoTables) {
  EXPECT_THROW(JetShape::get(0, 1), InvalidArgument);
  EXPECT_THROW(JetShape::get(5, 1), InvalidArgument);
  EXPECT_THROW(JetShape::get(2, -1), InvalidArgument);
  EXPECT_THROW(JetShape::get(2, maximum_order + 1), InvalidArgument);
}

}  // namespace
}  // namespace rfm
