#include <gmock/gmock.h>

#include <cmath>
#include <random>

#include "tests/core/operation_rows.hpp"

namespace rfm {
namespace {

constexpr double ulp = 0x1p-52;

template <int N, int K>
Jet<double, N, K> random_jet(std::mt19937& generator, double value) {
  std::uniform_real_distribution<double> uniform(-2, 2);
  Jet<double, N, K> jet(value);
  for (int i = 1; i < jet.size; ++i) jet.c[i] = uniform(generator);
  return jet;
}

template <class T, int N, int K>
Jet<T, N, K> converted(const Jet<double, N, K>& a) {
  Jet<T, N, K> jet;
  for (int i = 0; i < jet.size; ++i) jet.c[i] = T(a.c[i]);
  return jet;
}

// a + b ∓ √(a² + b²), operation by operation.
template <class Number>
Number composed(const Number& a, const Number& b, bool conjunction) {
  const Number root = sqrt(a * a + b * b);
  return conjunction ? a + b - root : a + b + root;
}

// The sum of the sizes of what is added up in coefficient `i` of the rule of rank one.
template <int N>
double condition(const Jet<double, N, 2>& a, const Jet<double, N, 2>& b, int i) {
  const auto& exponents = JetTables<N, 2>::exponents;
  const double s = std::hypot(a.c[0], b.c[0]);
  double sum = 2 * std::fabs(a.c[i]) + 2 * std::fabs(b.c[i]);
  if (degree(exponents[i]) < 2) return sum;
  double product = 1;
  for (int axis = 0; axis < N; ++axis)
    for (int k = 0; k < exponents[i][axis]; ++k)
      product *= std::fabs(b.c[0] * a.c[1 + axis]) + std::fabs(a.c[0] * b.c[1 + axis]);
  return sum + product / (s * s * s);
}

template <int N>
void expect_the_composed_formula() {
  std::mt19937 generator(N);
  std::uniform_real_distribution<double> exponent(-12, 1);
  for (int repeat = 0; repeat < 2000; ++repeat) {
    const auto value = [&] {
      return (generator() % 2 == 0 ? 1 : -1) * std::pow(10.0, exponent(generator));
    };
    const auto a = random_jet<N, 2>(generator, value()), b = random_jet<N, 2>(generator, value());
    const auto exact_a = converted<long double>(a), exact_b = converted<long double>(b);
    for (const bool conjunction : {true, false}) {
      const auto found = conjunction ? r0_conjunction(a, b) : r0_disjunction(a, b);
      const auto formula = composed(exact_a, exact_b, conjunction);
      const auto exact =
          conjunction ? r0_conjunction(exact_a, exact_b) : r0_disjunction(exact_a, exact_b);
      const auto blocks = conjunction ? r0_conjunction(converted<Batch>(a), converted<Batch>(b))
                                      : r0_disjunction(converted<Batch>(a), converted<Batch>(b));
      for (int i = 1; i < found.size; ++i) {
        const double tolerance = 8 * ulp * condition(a, b, i);
        EXPECT_NEAR(found.c[i], static_cast<double>(exact.c[i]), tolerance);
        EXPECT_NEAR(blocks.c[i][0], static_cast<double>(exact.c[i]), tolerance);
        // In long double the composed formula still cancels terms of the size of |∇|²/s itself.
        const double cancelled = 0x1p-60 * 400 / std::hypot(a.c[0], b.c[0]);
        EXPECT_NEAR(found.c[i], static_cast<double>(formula.c[i]), tolerance + cancelled);
      }
    }
  }
}

TEST(R0Jets, AreThoseOfTheComposedFormula) {
  expect_the_composed_formula<1>();
  expect_the_composed_formula<2>();
  expect_the_composed_formula<3>();
}

TEST(R0Jets, ValuesHaveFullRelativeAccuracy) {
  std::mt19937 generator(3);
  std::uniform_real_distribution<double> exponent(-300, 300);
  for (int repeat = 0; repeat < 5000; ++repeat) {
    const auto value = [&] {
      return (generator() % 2 == 0 ? 1 : -1) * std::pow(10.0, exponent(generator));
    };
    const double a = value(), b = repeat % 2 ? value() : a * (generator() % 100 - 49.5);
    const long double root = std::hypot(static_cast<long double>(a), static_cast<long double>(b));
    const long double sum = static_cast<long double>(a) + b;
    const long double both = sum > 0 ? 2.0L * a * b / (sum + root) : sum - root;
    const long double either = sum < 0 ? 2.0L * a * b / (sum - root) : sum + root;
    using Value = Jet<double, 1, 0>;
    EXPECT_NEAR(r0_conjunction(Value(a), Value(b)).c[0] / both, 1, 4 * ulp) << a << ' ' << b;
    EXPECT_NEAR(r0_disjunction(Value(a), Value(b)).c[0] / either, 1, 4 * ulp) << a << ' ' << b;
  }
}

TEST(R0Jets, OnTheBoundaryOfOneArgumentGradientsAreItsOwn) {
  // x = 0: x ∧ y = x + O(x²) where y > 0, x ∨ y likewise where y < 0; nothing is rounded.
  std::mt19937 generator(5);
  for (const double tiny : {0.0, 1e-17, -1e-17, 1e-300}) {
    const auto a = random_jet<3, 1>(generator, tiny);
    const auto inside = random_jet<3, 1>(generator, 2.7), outside = random_jet<3, 1>(generator, -1);
    const Jet<double, 3, 1> results[] = {r0_conjunction(a, inside), r0_conjunction(inside, a),
                                         r0_disjunction(a, outside), r0_disjunction(outside, a)};
    for (const auto& result : results) {
      EXPECT_NEAR(result.c[0], tiny, 2 * ulp * std::fabs(tiny));
      for (int i = 1; i < 4; ++i) EXPECT_DOUBLE_EQ(result.c[i], a.c[i]);
    }
  }
}

TEST(R0Jets, HigherOrdersBeginWithTheSameCoefficients) {
  std::mt19937 generator(6);
  const auto a = random_jet<2, 4>(generator, 0.3), b = random_jet<2, 4>(generator, -0.2);
  Jet<double, 2, 2> low_a, low_b;
  std::copy_n(a.c.begin(), low_a.size, low_a.c.begin());
  std::copy_n(b.c.begin(), low_b.size, low_b.c.begin());
  const auto high = r0_conjunction(a, b);
  const auto low = r0_conjunction(low_a, low_b);
  for (int i = 0; i < low.size; ++i) EXPECT_EQ(high.c[i], low.c[i]);
  const auto exact = composed(converted<long double>(a), converted<long double>(b), true);
  for (int i = low.size; i < high.size; ++i)
    EXPECT_NEAR(high.c[i], static_cast<double>(exact.c[i]), 1e-13 * std::fabs(high.c[i]) + 1e-11);
}

TEST(R0Jets, CornersHaveFiniteDerivativesByConvention) {
  auto a = Jet<double, 2, 2>::variable(0, 0), b = Jet<double, 2, 2>::variable(1, 0);
  for (const auto& result : {r0_conjunction(a, b), r0_disjunction(a, b)}) {
    EXPECT_EQ(result.c[0], 0);
    EXPECT_EQ(result.c[1], 1);
    EXPECT_EQ(result.c[2], 1);
    for (int i = 3; i < 6; ++i) EXPECT_EQ(result.c[i], 0);
  }
}

}  // namespace
}  // namespace rfm
