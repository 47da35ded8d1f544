#include "core/jet.hpp"
#include "core/jet_inverse_functions.hpp"
#include "core/jet_piecewise.hpp"
#include "core/jet_powers.hpp"
#include "core/jet_r_functions.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <random>

namespace rfm {
namespace {

static_assert(sizeof(Jet<double, 2, 2>) == 6 * sizeof(double));
static_assert(sizeof(Jet<double, 3, 3>) == 20 * sizeof(double));
static_assert(sizeof(Jet<Batch, 2, 1>) == 3 * sizeof(Batch));

double binomial(int n, int k) { return k == 0 ? 1 : binomial(n - 1, k - 1) * n / k; }

// Largest difference of coefficients, relative to the largest one.
template <class JetType>
double difference(const JetType& a, const JetType& b) {
  double largest = 1, difference = 0;
  for (int i = 0; i < a.size; ++i) {
    largest = std::max(largest, std::fabs(b.c[i]));
    if (!(std::fabs(a.c[i] - b.c[i]) <= difference)) difference = std::fabs(a.c[i] - b.c[i]);
  }
  return difference / largest;
}

template <class JetType>
void expect_same(const JetType& a, const JetType& b, double tolerance = 2e-14) {
  EXPECT_LE(difference(a, b), tolerance)
      << testing::PrintToString(a.c) << "\n is not " << testing::PrintToString(b.c);
}

// The largest sum of absolute terms among the coefficients of a product.
template <class JetType>
double largest_term(JetType a, JetType b) {
  for (double& coefficient : a.c) coefficient = std::fabs(coefficient);
  for (double& coefficient : b.c) coefficient = std::fabs(coefficient);
  const JetType product = a * b;
  return *std::ranges::max_element(product.c);
}

template <class JetType>
JetType random_jet(double value) {
  static std::mt19937 generator(1);
  std::uniform_real_distribution<double> uniform(-1, 1);
  JetType jet;
  for (double& coefficient : jet.c) coefficient = uniform(generator);
  jet.c[0] = value;
  return jet;
}

template <class JetType>
class Jets : public testing::Test {};
using JetTypes = testing::Types<Jet<double, 1, 0>, Jet<double, 1, 1>, Jet<double, 1, 6>,
                                Jet<double, 2, 4>, Jet<double, 3, 3>, Jet<double, 4, 2>>;
TYPED_TEST_SUITE(Jets, JetTypes);

constexpr double some_values[] = {-2.3, -1.1, -0.4, 0.3, 0.9, 1.7};
constexpr double positive_values[] = {0.3, 0.9, 1.7, 4.0};

TYPED_TEST(Jets, FormARing) {
  const auto a = random_jet<TypeParam>(1.3), b = random_jet<TypeParam>(-0.6),
             c = random_jet<TypeParam>(0.7);
  expect_same(a * b, b * a);
  expect_same((a * b) * c, a * (b * c));
  expect_same((a + b) * c, a * c + b * c);
  expect_same(a - a, TypeParam(0.0), 0);
  expect_same(a + (-b), a - b, 0);
  expect_same(square(a), a * a);
}

TYPED_TEST(Jets, QuotientTimesDivisorIsTheDividend) {
  for (const double value : some_values) {
    const auto a = random_jet<TypeParam>(1.3), b = random_jet<TypeParam>(value);
    expect_same((a / b) * b, a, 1e-12);
  }
}

TYPED_TEST(Jets, ValueOfAQuotientIsRoundedOnceWhateverTheOrder) {
  EXPECT_EQ((TypeParam(49.0) / TypeParam(49.0)).value(), 1.0);
  EXPECT_EQ(mod(TypeParam(49.0), TypeParam(49.0)).value(), 0.0);
}

TYPED_TEST(Jets, SquaresOfSineAndCosineSumToOne) {
  for (const double value : some_values) {
    const auto a = random_jet<TypeParam>(value);
    expect_same(sin(a) * sin(a) + cos(a) * cos(a), TypeParam(1.0));
    expect_same(cosh(a) * cosh(a) - sinh(a) * sinh(a), TypeParam(1.0), 2e-13);
  }
}

TYPED_TEST(Jets, TangentsAreQuotientsOfSineAndCosine) {
  for (const double value : some_values) {
    const auto a = random_jet<TypeParam>(value);
    expect_same(tan(a), sin(a) / cos(a), 1e-12);
    expect_same(tanh(a), sinh(a) / cosh(a));
  }
}

TYPED_TEST(Jets, RootsInvertPowers) {
  for (const double value : positive_values) {
    const auto a = random_jet<TypeParam>(value);
    expect_same(sqrt(a * a), a, 1e-13);
    expect_same(sqrt(a) * sqrt(a), a);
    // Terms that cancel in the cube are larger than a, and rounding is relative to them.
    const auto root = cbrt(-a);
    const double terms = largest_term(root * root, root);
    expect_same(root * root * root, -a, std::max(2e-14, 2e-15 * terms));
    expect_same(real_power(a, 1.5) * real_power(a, 1.5), a * a * a);
    expect_same(real_power(a, -0.7) * real_power(a, 0.7), TypeParam(1.0), 1e-12);
  }
}

TYPED_TEST(Jets, IntegerPowersAreRepeatedProducts) {
  for (const double value : some_values) {
    const auto a = random_jet<TypeParam>(value);
    TypeParam product(1.0);
    for (int exponent = 0; exponent <= 9; ++exponent, product = product * a) {
      expect_same(integer_power(a, exponent), product, 1e-13);
      // The terms that cancel in a⁻ⁿ aⁿ = 1 are larger than 1: rounding is relative to them.
      const auto inverse = integer_power(a, -exponent);
      expect_same(inverse * product, TypeParam(1.0), 1e-14 * largest_term(inverse, product));
    }
  }
}

TYPED_TEST(Jets, ExponentialAndLogarithmAreInverse) {
  for (const double value : positive_values) {
    const auto a = random_jet<TypeParam>(value);
    expect_same(exp(log(a)), a, 1e-13);
    expect_same(log(exp(a)), a, 1e-13);
    expect_same(general_power(a, TypeParam(3.0)), a * a * a, 1e-13);
  }
}

TYPED_TEST(Jets, InverseFunctionsInvert) {
  for (const double value : {-1.0, -0.6, 0.0, 0.2, 1.0}) {
    const auto a = random_jet<TypeParam>(value);
    expect_same(asin(sin(a)), a, 1e-11);
    expect_same(acos(cos(a + TypeParam(1.5))), a + TypeParam(1.5), 1e-11);
    expect_same(atan(tan(a)), a, 1e-11);
    expect_same(asinh(sinh(a)), a, 1e-12);
  }
}

TYPED_TEST(Jets, PolarAngleIsRecoveredInEveryQuadrant) {
  for (double angle = -3.1; angle < 3.14; angle += 0.1) {
    const auto t = random_jet<TypeParam>(angle), r = random_jet<TypeParam>(1.7);
    expect_same(atan2(r * sin(t), r * cos(t)), t, 1e-13);
  }
}

TYPED_TEST(Jets, HypotAndRFunctionsSatisfyTheirQuadratics) {
  for (const double x : some_values)
    for (const double y : some_values) {
      const auto a = random_jet<TypeParam>(x), b = random_jet<TypeParam>(y);
      expect_same(square(hypot(a, b)), a * a + b * b, 1e-13);
      const auto both = r0_conjunction(a, b), either = r0_disjunction(a, b);
      expect_same(both + either, scaled(2.0, a + b), 1e-12);
      expect_same(both * either, scaled(2.0, a * b), 1e-12);
    }
}

TYPED_TEST(Jets, PiecewiseFunctionsAreOneOfTheirBranches) {
  for (const double x : some_values) {
    const auto a = random_jet<TypeParam>(x), b = random_jet<TypeParam>(0.31);
    expect_same(abs(a), x < 0 ? -a : a, 0);
    expect_same(sign(a), TypeParam(x < 0 ? -1.0 : 1.0), 0);
    expect_same(min(a, b), x < 0.31 ? a : b, 0);
    expect_same(max(a, b), x < 0.31 ? b : a, 0);
    expect_same(step(a), TypeParam(x < 0 ? 0.0 : 1.0), 0);
    expect_same(choose(less_than(a, b), a, b), min(a, b), 0);
    expect_same(mod(a, b), a - b * TypeParam(std::floor(x / 0.31)), 1e-15);
  }
}

// f(a) differentiated is f′(a) ∂a, to one order less.
template <int N, int K>
void expect_derivative(const Jet<double, N, K>& function, const Jet<double, N, K>& derivative,
                       const Jet<double, N, K>& argument) {
  if constexpr (K > 0)
    for (int axis = 0; axis < N; ++axis) {
      auto left = differentiate(function, axis), right = derivative * differentiate(argument, axis);
      for (int i = jet_size(N, K - 1); i < left.size; ++i) left.c[i] = right.c[i] = 0;
      expect_same(left, right, 1e-13);
    }
}

TYPED_TEST(Jets, DerivativesAreThoseOfTheTables) {
  for (const double value : {-0.7, 0.2, 0.6}) {
    const auto a = random_jet<TypeParam>(value);
    const TypeParam one(1.0);
    expect_derivative(erf(a), scaled(2 / std::sqrt(std::numbers::pi), exp(-(a * a))), a);
    expect_derivative(sin(a), cos(a), a);
    expect_derivative(cos(a), -sin(a), a);
    expect_derivative(sinh(a), cosh(a), a);
    expect_derivative(tanh(a), one - tanh(a) * tanh(a), a);
    expect_derivative(atan(a), one / (one + a * a), a);
    expect_derivative(asin(a), one / sqrt(one - a * a), a);
    expect_derivative(asinh(a), one / sqrt(one + a * a), a);
  }
}

TEST(Jet, ExponentialOfSineOfProductHasItsFourthDerivatives) {
  // With g(t) = exp(sin t) and t = x y:  ∂ₓⁱ∂ᵧʲ g = Σₖ C(i,k) j!/(j−k)! x^{j−k} y^{i−k}
  // g^{(i+j−k)}, and g^{(n+1)} = Σₘ C(n,m) cos^{(m)} g^{(n−m)}.
  const double x = 0.7, y = -1.3, t = x * y;
  const double cosines[] = {std::cos(t), -std::sin(t), -std::cos(t), std::sin(t)};
  double g[5] = {std::exp(std::sin(t))};
  for (int n = 0; n < 4; ++n)
    for (int m = 0; m <= n; ++m) g[n + 1] += binomial(n, m) * cosines[m] * g[n - m];

  using Number = Jet<double, 2, 4>;
  const Number f = exp(sin(Number::variable(0, x) * Number::variable(1, y)));
  for (int i = 0; i <= 4; ++i)
    for (int j = 0; i + j <= 4; ++j) {
      double expected = 0, falling = 1;
      for (int k = 0; k <= std::min(i, j); falling *= j - k, ++k)
        expected +=
            binomial(i, k) * falling * std::pow(x, j - k) * std::pow(y, i - k) * g[i + j - k];
      const MultiIndex alpha{static_cast<std::uint8_t>(i), static_cast<std::uint8_t>(j)};
      EXPECT_NEAR(f.derivative(alpha), expected, 1e-13 * (1 + std::fabs(expected)))
          << "∂x^" << i << " ∂y^" << j;
    }
}

TEST(Jet, LowerOrderIsAPrefix) {
  using High = Jet<double, 2, 4>;
  using Low = Jet<double, 2, 2>;
  const auto function = [](const auto& a, const auto& b) {
    return atan2(sqrt(a) * exp(b), log(a) - sin(b)) / (tanh(a) + erf(b)) + hypot(a, b);
  };
  for (const double value : positive_values) {
    const auto a = random_jet<High>(value), b = random_jet<High>(0.5);
    Low low_a, low_b;
    std::copy_n(a.c.begin(), Low::size, low_a.c.begin());
    std::copy_n(b.c.begin(), Low::size, low_b.c.begin());
    const High high = function(a, b);
    Low prefix;
    std::copy_n(high.c.begin(), Low::size, prefix.c.begin());
    expect_same(function(low_a, low_b), prefix, 1e-15);
  }
}

TEST(Jet, DerivativesAreFiniteByConventionWhereTheyDoNotExist) {
  using Number = Jet<double, 2, 3>;
  const Number zero = Number::variable(0, 0.0), also_zero = Number::variable(1, 0.0),
               one = Number::variable(0, 1.0);
  const Number singular[] = {sqrt(zero),
                             cbrt(zero),
                             abs(zero),
                             real_power(zero, 0.3),
                             real_power(zero, 2.5),
                             asin(one),
                             acos(one),
                             asin(-one),
                             hypot(zero, also_zero),
                             atan2(zero, also_zero),
                             r0_conjunction(zero, also_zero),
                             r0_disjunction(zero, also_zero),
                             general_power(zero, one),
                             min(zero, also_zero)};
  for (const Number& jet : singular)
    EXPECT_THAT(jet.c, testing::Each(testing::Truly([](double c) { return std::isfinite(c); })));
  // Where there is no finite value there are no derivatives either.
  for (const Number& jet : {log(zero), real_power(zero, -1.5), integer_power(zero, -1),
                            Number(1.0) / zero, general_power(zero, -one)}) {
    EXPECT_TRUE(std::isinf(jet.value()));
    EXPECT_FALSE(std::isfinite(jet.derivative({1, 0})));
  }
}

TEST(Jet, PowersOfZeroWithAVariableExponentHaveTheirRegularDerivatives) {
  // ∂ᵏ x^y / ∂xᵏ at (0, k) is k!; those by y are singular or 0.
  for (int k = 0; k <= 3; ++k) {
    const auto power = general_power(Jet<double, 2, 4>::variable(0, 0.0),
                                     Jet<double, 2, 4>::variable(1, double(k)));
    for (int i = 0; i < power.size; ++i)
      EXPECT_EQ(power.c[i], i == jet_index(2, {static_cast<std::uint8_t>(k), 0}) ? 1 : 0);
  }
}

TEST(Jet, PowersOfZeroHaveTheirRegularDerivatives) {
  // d/dx x^2.5 = 2.5 x^1.5 and d²/dx² = 3.75 x^0.5 vanish at 0; the third is singular, 0 by
  // convention.
  const auto cube = real_power(Jet<double, 1, 3>::variable(0, 0.0), 3.0);
  EXPECT_EQ(cube.derivative({3}), 6);
  const auto power = real_power(Jet<double, 1, 3>::variable(0, 0.0), 2.5);
  EXPECT_THAT(power.c, testing::Each(0.0));
}

TEST(Jet, InverseSineIsAccurateNextToItsEnds) {
  // asin′(1 − e) = 1 / √(2e − e²)
  const double e = 0x1p-40;
  const auto jet = asin(Jet<double, 1, 1>::variable(0, 1 - e));
  const double exact = 1 / std::sqrt(e * (2 - e));
  EXPECT_NEAR(jet.derivative({1}), exact, 1e-14 * exact);
}

TEST(Jet, ConjunctionDoesNotCancelNextToTheBoundary) {
  // x ∧ y = x − x²/(2y) + O(x³) for small x.
  using Number = Jet<double, 2, 1>;
  for (const double x : {1e-12, 1e-100, 1e-300}) {
    const double both = r0_conjunction(Number(x), Number(2.0)).value();
    EXPECT_NEAR(both, x * (1 - x / 4), 4e-16 * x);
    EXPECT_NEAR(r0_disjunction(Number(-x), Number(-2.0)).value(), -both, 4e-16 * x);
  }
}

}  // namespace
}  // namespace rfm
