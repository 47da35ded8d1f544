// Derivatives where the plain formulas cancel, overflow or underflow, to 8 ulp of the closed form.
// References with many digits are from 60-digit arithmetic.

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>

#include "core/field.hpp"
#include "core/operation_rules.hpp"
#include "core/r_functions.hpp"
#include "core/tape.hpp"

namespace rfm {
namespace {

constexpr double ulp = std::numeric_limits<double>::epsilon();
const Field x = x_coordinate(), y = y_coordinate();

// ∂^alpha f at a point, by the tape of single points and by that of blocks.
void expect_derivative(const Field& f, const Point& point, const MultiIndex& alpha, double truth) {
  const int order = degree(alpha);
  const Tape tape({f}, {order}, 2);
  Tape::Workspace workspace(tape);
  tape.evaluate({.coordinates = {&point[0], &point[1], &point[2]}, .count = 1}, workspace);
  const double block = workspace.coefficient(0, jet_index(2, alpha))[0] * factorial(alpha);
  EXPECT_NEAR(block, truth, 8 * ulp * std::fabs(truth)) << point[0] << ' ' << point[1];
  Field derivative = f;
  for (int axis = 0; axis < 2; ++axis)
    for (int i = 0; i < alpha[axis]; ++i) derivative = partial(derivative, axis);
  const double single = Tape({derivative}, {0}, 2).value(point);
  EXPECT_NEAR(single, truth, 8 * ulp * std::fabs(truth)) << point[0] << ' ' << point[1];
}

constexpr MultiIndex along_x{1, 0}, along_y{0, 1}, twice_x{2, 0}, twice_y{0, 2};

TEST(JetConditions, HyperbolicTangentKeepsItsDerivativeFarOut) {
  for (const double at : {0.5, 5.0, 15.0, 20.0, 300.0})
    expect_derivative(tanh(x), {at, 0}, along_x, 1 / std::cosh(at) / std::cosh(at));
}

TEST(JetConditions, InverseFunctionsKeepTheirDerivatives) {
  expect_derivative(asinh(x), {1e300, 0}, along_x, 1e-300);
  expect_derivative(asinh(x), {-1e200, 0}, along_x, 1e-200);
  // x (1 − x²)^{−3/2}
  for (const double at : {1e-3, 1e-4, 1e-8, 1e-100}) {
    const double truth = at / std::pow(1 - at * at, 1.5);
    expect_derivative(asin(x), {at, 0}, twice_x, truth);
    expect_derivative(acos(x), {at, 0}, twice_x, -truth);
  }
  expect_derivative(atan2(x, y), {1e-170, 1e-170}, along_x, 5e169);
  expect_derivative(atan2(x, y), {1e-170, 1e-170}, along_y, -5e169);
  expect_derivative(atan2(x, y), {1e200, 1e200}, along_x, 5e-201);
}

TEST(JetConditions, RootsOfTheSmallestNumbersHaveSlopes) {
  expect_derivative(sqrt(x), {1e-310, 0}, along_x, 0.5 / std::sqrt(1e-310));
  expect_derivative(cbrt(x), {1e-310, 0}, along_x, 1 / (3 * std::pow(std::cbrt(1e-310), 2)));
}

TEST(JetConditions, HypotKeepsItsCurvatureForSidesOfAnySize) {
  // y² / (x² + y²)^{3/2}
  const auto curvature = [](long double a, long double b) {
    const long double root = hypotl(a, b);
    return static_cast<double>(b / root * (b / root) / root);
  };
  const double sizes[] = {1e-300, 1e-200, 1e-3, 0.1, 1, 49, 1e4, 1e150, 1e300};
  for (const double a : sizes)
    for (const double b : sizes) {
      if (curvature(a, b) < 1e-290 || curvature(a, b) > 1e290) continue;
      expect_derivative(hypot(x, y), {a, -b}, twice_x, curvature(a, b));
      expect_derivative(hypot(x, y), {-b, a}, twice_y, curvature(a, b));
    }
}

// Of a + b − (aᵖ + bᵖ)^{1/p}, a, b > 0: 1 − (1 + (b/a)^p)^{1/p − 1}, without cancellation.
double rp_slope(double a, double b, int p) {
  return -std::expm1((1.0 / p - 1) * std::log1p(std::pow(b / a, p)));
}

TEST(JetConditions, RpConjunctionsOfHighOrderHaveSlopesNearCorners) {
  for (const int p : {4, 16, 36, 64})
    for (const double size : {1e-100, 1e-9, 1e-6, 1e-5, 1.0, 1e5, 1e300}) {
      const Field f = apply(Operation::rp_conjunction, {x, y}, p);
      expect_derivative(f, {size, size}, along_x, rp_slope(1, 1, p));
      expect_derivative(f, {size, size}, along_y, rp_slope(1, 1, p));
      expect_derivative(f, {size, 0.75 * size}, along_x, rp_slope(1, 0.75, p));
      const Field g = apply(Operation::rp_disjunction, {x, y}, p);
      expect_derivative(g, {-size, -size}, along_x, rp_slope(1, 1, p));
    }
  expect_derivative(apply(Operation::rp_conjunction, {x, y}, 4), {1000, -0.1}, along_x,
                    rp_slope(1000, 0.1, 4));
}

TEST(JetConditions, RpEquivalenceHasSlopesNearCornersAndForUnequalArguments) {
  // ∂/∂x of xy / (xᵖ + yᵖ)^{1/p}: (y / norm)^{p + 1}
  for (const int p : {4, 16, 64})
    for (const double size : {1e-100, 1e-6, 1.0, 1e5, 1e300}) {
      const Field f = apply(Operation::rp_equivalence, {x, y}, p);
      expect_derivative(f, {size, size}, along_x, std::pow(2.0, -(p + 1.0) / p));
    }
  const double norm = std::pow(1 + std::pow(1e-3 / 49, 4), 0.25);
  expect_derivative(apply(Operation::rp_equivalence, {x, y}, 4), {1e-3, 49}, along_y,
                    std::pow(1e-3 / 49 / norm, 5));
}

TEST(JetConditions, RAlphaConjunctionKeepsItsSlopeForUnequalArguments) {
  // 60 digits: 2.500002500000468…e-13
  expect_derivative(apply(Operation::ralpha_conjunction, {x, y}, 0.5), {1e-3, 1000}, along_y,
                    2.5000025000004688e-13);
}

TEST(JetConditions, JetsOfMoreThan256CoefficientsMultiply) {
  using Number = Jet<double, 4, 7>;
  const auto v = [](int axis) { return Number::variable(axis, 0.1 * (axis + 1)); };
  const Number product = exp(v(0)) * exp(Number(2.0) * v(1)) * exp(-v(2)) * exp(v(3));
  const double value = std::exp(0.1 + 0.4 - 0.3 + 0.4);
  for (int i = 0; i < Number::size; ++i) {
    const MultiIndex& alpha = JetTables<4, 7>::exponents[i];
    const double truth = value * std::pow(2, alpha[1]) * (alpha[2] % 2 ? -1 : 1);
    EXPECT_NEAR(product.c[i] * factorial(alpha), truth, 1e-13 * std::fabs(truth)) << i;
  }
}

}  // namespace
}  // namespace rfm
