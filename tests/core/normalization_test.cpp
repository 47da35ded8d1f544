#include <gtest/gtest.h>

#include <cmath>

#include "core/derivative_fields.hpp"
#include "core/evaluate.hpp"
#include "core/primitives.hpp"
#include "core/r_functions.hpp"

// Normalisation is kept by R-functions: theorem 4 of V. Shapiro, Acta Numerica 16 (2007).
namespace rfm {
namespace {

// The derivatives of f of orders 0 … 4 along the line through `at` in direction `normal`.
std::array<double, 5> along(const Field& f, const Point& at, const Point& normal) {
  const PointJet jet = evaluate(f, at, 4, 2);
  std::array<double, 5> result{};
  for (int k = 0; k <= 4; ++k) {
    double binomial = 1;
    for (int i = 0; i <= k; ++i) {
      result[k] +=
          binomial * std::pow(normal[0], i) * std::pow(normal[1], k - i) * jet.derivative(i, k - i);
      binomial = binomial * (k - i) / (i + 1);
    }
  }
  return result;
}

struct Shape {
  Field ellipse, line, disk;  // the ellipse normalised to `order`
};

Shape shapes(int order) {
  return {normalize(ellipse({0.1, 0}, {1.5, 0.8}, 0.3).primitives()[0]->level, 2, order),
          half_plane({0, -0.2}, {0.3, 1}).primitives()[0]->function,
          circle({3, 0}, 1).primitives()[0]->function};
}

// Regular points of the ellipse above the line.
std::vector<std::pair<Point, Point>> points_of_the_ellipse() {
  std::vector<std::pair<Point, Point>> list;
  for (const double t : {0.4, 1.1, 1.9, 2.4}) {
    const double c = std::cos(0.3), s = std::sin(0.3);
    const double p = 1.5 * std::cos(t), q = 0.8 * std::sin(t);
    const double n = -std::cos(t) / 1.5, m = -std::sin(t) / 0.8, length = std::hypot(n, m);
    list.push_back({{0.1 + c * p - s * q, s * p + c * q},
                    {(c * n - s * m) / length, (s * n + c * m) / length}});
  }
  return list;
}

class Order : public testing::TestWithParam<int> {};
INSTANTIATE_TEST_SUITE_P(Normalization, Order, testing::Values(1, 2, 3));

TEST_P(Order, IsKeptByRpOfAHigherExponent) {
  const int order = GetParam();
  const Rp system{order + 1 + (order + 1) % 2};
  const Shape s = shapes(order);
  const Field f = disjunction(conjunction(s.ellipse, s.line, system), s.disk, system);
  for (const auto& [at, normal] : points_of_the_ellipse()) {
    const auto d = along(f, at, normal), of_primitive = along(s.ellipse, at, normal);
    EXPECT_NEAR(d[0], 0, 1e-12);
    EXPECT_NEAR(d[1], 1, 1e-12);
    for (int k = 2; k <= order; ++k) EXPECT_NEAR(d[k], 0, 1e-10) << order << ", " << k;
    for (int k = 0; k < system.p; ++k) EXPECT_NEAR(d[k], of_primitive[k], 1e-9) << k;
  }
}

TEST_P(Order, IsLostWithALowerExponent) {
  // R₀ keeps order 1 and no more, whatever the order of its arguments.
  const int order = GetParam();
  const Shape s = shapes(order);
  const Field f = conjunction(s.ellipse, s.line);
  for (const auto& [at, normal] : points_of_the_ellipse()) {
    EXPECT_NEAR(along(f, at, normal)[1], 1, 1e-12);
    if (order > 1) {
      EXPECT_GT(std::fabs(along(f, at, normal)[2]), 0.05);
    }
  }
}

TEST(Normalization, IsFormula49) {
  // f/√(f² + |∇f|²): ±1 where the gradient vanishes, between −1 and 1 everywhere.
  const Field x = x_coordinate(), y = y_coordinate();
  const Field omega = normalize(3 - x * x - 2 * y * y, 2);
  EXPECT_DOUBLE_EQ(evaluate(omega, {0, 0}, 0, 2).derivative(0, 0), 1);
  EXPECT_DOUBLE_EQ(evaluate(omega, {1, 0.5}, 0, 2).derivative(0, 0),
                   1.5 / std::sqrt(1.5 * 1.5 + 4 + 4));
  EXPECT_NEAR(evaluate(omega, {1e8, 0}, 0, 2).derivative(0, 0), -1, 1e-15);
}

TEST(Normalization, OfAnyOrderIsTheSameInAnyUnitInLengthsOfTheShape) {
  const auto normalized = [](double unit, int order) {
    return normalize(ellipse({0.1 * unit, 0}, {1.5 * unit, 0.8 * unit}, 0.3).primitives()[0]->level,
                     2, order, 0.8 * unit);
  };
  for (int order = 1; order <= 4; ++order)
    for (const double unit : {1e-3, 1e3, 1e6})
      for (const Point at : {Point{0.9, 0.2}, Point{0, 0.5}, Point{-0.2, 1.1}}) {
        const double expected = evaluate(normalized(1, order), at, 0, 2).derivative(0, 0);
        const Field scaled = normalized(unit, order);
        const Point there{unit * at[0], unit * at[1]};
        EXPECT_NEAR(evaluate(scaled, there, 0, 2).derivative(0, 0) / unit, expected, 1e-10)
            << order << ", " << unit;
      }
}

TEST(Normalization, ChangesSignWithEachInversion) {
  // x₁ ∧ ¬(x₂ ∨ ¬x₃): inversion degrees 0, 1 and 2 (the example of theorem 4, mended).
  const Shape s = shapes(1);
  const auto slope = [&](const Field& f) {
    const auto [at, normal] = points_of_the_ellipse()[0];
    return along(f, at, normal)[1];
  };
  const Field yes = 1.0, no = -1.0;
  const auto f = [](const Field& a, const Field& b, const Field& c) {
    return conjunction(a, -disjunction(b, -c));
  };
  EXPECT_NEAR(slope(f(s.ellipse, no, yes)), 1, 1e-12);
  EXPECT_NEAR(slope(f(yes, s.ellipse, yes)), -1, 1e-12);
  EXPECT_NEAR(slope(f(yes, no, s.ellipse)), 1, 1e-12);
}

}  // namespace
}  // namespace rfm
