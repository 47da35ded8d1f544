#include "core/jet_scaling.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "core/field.hpp"
#include "core/operation_rules.hpp"
#include "core/r_functions.hpp"
#include "core/tape.hpp"

namespace rfm {
namespace {

const Field x = x_coordinate(), y = y_coordinate();

// The Taylor coefficients of f at a point, by the tape of single points and by that of blocks, as
// multiples of 10^scale per degree and 10^size in all, are those of `truth`.
void expect_coefficients(const Field& f, const Point& point, int order,
                         const std::function<double(const MultiIndex&)>& truth, double tolerance,
                         int size = 0, int scale = 0) {
  const Tape tape({f}, {order}, 2);
  Tape::Workspace workspace(tape);
  tape.evaluate({.coordinates = {&point[0], &point[1], &point[2]}, .count = 1}, workspace);
  const std::vector<double> jet = tape.jet(point);
  const JetShape& shape = JetShape::get(2, order);
  for (int i = 0; i < shape.size(); ++i) {
    const MultiIndex& alpha = shape.exponent(i);
    const long double unit = std::pow(10.0L, size - degree(alpha) * scale);
    const double expected = truth(alpha);
    EXPECT_NEAR(static_cast<double>(jet[i] / unit), expected, tolerance)
        << "coefficient " << i << " at " << point[0] << ", " << point[1];
    EXPECT_NEAR(static_cast<double>(workspace.coefficient(0, i)[0] / unit), expected, tolerance)
        << "coefficient " << i << " at " << point[0] << ", " << point[1] << ", in a block";
  }
}

double is_along_x(const MultiIndex& alpha, const std::function<double(int)>& coefficient) {
  return alpha[1] == 0 ? coefficient(alpha[0]) : 0;
}

// Orders with kernels of their own and beyond.
class JetScaling : public testing::TestWithParam<int> {};
INSTANTIATE_TEST_SUITE_P(Orders, JetScaling, testing::Values(2, 3, 4, 6));

TEST_P(JetScaling, LogarithmsOfExponentialsAreLinear) {
  for (const double at : {600.0, -600.0, 20.0}) {
    const auto linear = [at](const MultiIndex& alpha) {
      return is_along_x(alpha, [at](int k) { return k == 0 ? at : k == 1 ? 1 : 0; });
    };
    expect_coefficients(log(exp(x)), {at, 0}, GetParam(), linear, 1e-12);
    if (at < 100) continue;
    expect_coefficients(log(1 + exp(x)), {at, 0}, GetParam(), linear, 1e-12);
    expect_coefficients(log(cosh(x)) + std::log(2.0), {at, 0}, GetParam(), linear, 1e-12);
    expect_coefficients(asinh(exp(x)) - std::log(2.0), {at, 0}, GetParam(), linear, 1e-12);
  }
  for (const double at : {200.0, 300.0, 400.0})
    expect_coefficients(
        log(1 + exp(x)), {at, 0}, GetParam(),
        [at](const MultiIndex& alpha) {
          return is_along_x(alpha, [at](int k) { return k == 0 ? at : k == 1 ? 1 : 0; });
        },
        1e-12);
}

TEST_P(JetScaling, PowersOfExponentialsAreExponentials) {
  for (const double at : {600.0, -600.0, 3.0}) {
    const auto exponential = [at](double rate) {
      return [=](const MultiIndex& alpha) {
        return is_along_x(alpha, [=](int k) { return std::pow(rate, k) / std::tgamma(k + 1); });
      };
    };
    const Field e = exp(x);
    expect_coefficients(sqrt(e) * std::exp(-at / 2), {at, 0}, GetParam(), exponential(0.5), 1e-12);
    expect_coefficients(cbrt(e) * std::exp(-at / 3), {at, 0}, GetParam(), exponential(1.0 / 3),
                        1e-12);
    expect_coefficients(pow(e, 0.7) * std::exp(-at * 0.7), {at, 0}, GetParam(), exponential(0.7),
                        1e-12);
    expect_coefficients(1 / e * std::exp(at), {at, 0}, GetParam(), exponential(-1), 1e-12);
    expect_coefficients(
        e / (e * e) * std::exp(at), {at / 2, 0}, GetParam(),
        [at, exponential](const MultiIndex& alpha) {
          return std::exp(at / 2) * exponential(-1)(alpha);
        },
        1e-12 * std::exp(at / 2));
  }
}

// log ∛(y^x) = ⅓ x log y: y^x is beyond 1e110 in size or below 1e-110, its derivatives are, too.
TEST(JetScalingOfPowers, LogarithmsOfRootsOfPowersAreProducts) {
  const double b = 1.5;
  for (const double at : {650.0, -650.0}) {
    const auto product = [at, b](const MultiIndex& alpha) {
      const double of_y[] = {std::log(b), 1 / b, -0.5 / (b * b)};
      return (alpha[0] == 0 ? at : alpha[0] == 1 ? 1 : 0) * of_y[alpha[1]] / 3;
    };
    expect_coefficients(log(cbrt(pow(y, x))), {at, b}, 2, product, 1e-9);
  }
}

// The derivatives of √r², log r² and r⁻² at (3, 4) times a power of ten, by those at (3, 4).
TEST_P(JetScaling, FunctionsOfTheRadiusScale) {
  const auto jets = [](const Field& f) {
    return [jet = Tape({f}, {6}, 2).jet({3, 4})](const MultiIndex& alpha) {
      return jet[jet_index(2, alpha)];
    };
  };
  for (const int power : {-110, -60, 60, 110}) {
    const double unit = std::pow(10.0, power);
    const Point point{3 * unit, 4 * unit};
    // Degrees of which the coefficients are numbers at all.
    const int order = std::min(GetParam(), 300 / std::abs(power) + 1);
    const int even = std::max(0, std::min(GetParam(), 300 / std::abs(power) - 2));
    const Field radius = x * x + y * y;
    expect_coefficients(sqrt(radius), point, order, jets(sqrt(radius)), 1e-13, power, power);
    expect_coefficients(log(radius) - 2 * std::log(unit), point, order - 1, jets(log(radius)),
                        1e-12, 0, power);
    expect_coefficients(1 / radius, point, even, jets(1 / radius), 1e-13, -2 * power, power);
    for (const Field& f : {hypot(x, y), conjunction(x, y), conjunction(x, y, RAlpha{0.5}),
                           conjunction(-x, y, Rp{4}), exclusive_or(x, y)})
      expect_coefficients(f, point, order, jets(f), 1e-12, power, power);
    expect_coefficients(atan2(x, y), point, order - 1, jets(atan2(x, y)), 1e-13, 0, power);
  }
}

TEST_P(JetScaling, HomogeneousFunctionsOfExponentialsAreExponentials) {
  for (const double at : {650.0, -650.0}) {
    const Field a = 3 * exp(x), b = 4 * exp(x);
    const Field unit = exp(-x_coordinate());  // brings the results to constants
    const auto constant = [](double factor) {
      return [=](const MultiIndex& alpha) { return degree(alpha) == 0 ? factor : 0; };
    };
    const int order = GetParam();
    expect_coefficients(hypot(a, b) * unit, {at, 0}, order, constant(5), 1e-11);
    expect_coefficients(conjunction(a, b) * unit, {at, 0}, order, constant(2), 1e-11);
    expect_coefficients(disjunction(a, b) * unit, {at, 0}, order, constant(12), 1e-11);
    expect_coefficients(exclusive_or(a, b) * unit, {at, 0}, order,
                        constant(2 * std::sqrt(13.0) - 10), 1e-11);
    expect_coefficients(conjunction(a, b, Rp{4}) * unit, {at, 0}, order,
                        constant(7 - std::pow(81 + 256, 0.25)), 1e-11);
    expect_coefficients(atan2(a, b), {at, 0}, order, constant(std::atan2(3, 4)), 1e-12);
    expect_coefficients(a / b, {at, 0}, order, constant(0.75), 1e-12);
  }
}

}  // namespace
}  // namespace rfm
