#include "solution_structures/singular_functions.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <numbers>

#include "core/error.hpp"
#include "core/evaluate.hpp"

namespace rfm {
namespace {

constexpr double pi = std::numbers::pi;
const Field x = x_coordinate(), y = y_coordinate();
const Structure psi = Structure::undetermined();

// A reentrant corner at (1, 2) whose first side points along 0.3 radians.
const Corner corner{{1, 2}, 0.3, 1.5 * pi};
Point polar(double r, double theta) {
  return {1 + r * std::cos(0.3 + theta), 2 + r * std::sin(0.3 + theta)};
}

TEST(CornerFunctions, AreThePowersOfTheirDefinition) {
  for (const double alpha : {2.0 / 3, 4.0 / 3, 0.5})
    for (double r = 0.1; r < 2; r += 0.37)
      for (double theta = 0.01; theta < 1.5 * pi; theta += 0.3) {
        const double power = std::pow(r, alpha);
        EXPECT_NEAR(value_at(corner_sine(corner, alpha), polar(r, theta)),
                    power * std::sin(alpha * theta), 1e-14 * (1 + power));
        EXPECT_NEAR(value_at(corner_cosine(corner, alpha), polar(r, theta)),
                    power * std::cos(alpha * theta), 1e-14 * (1 + power));
      }
}

TEST(CornerFunctions, AreHarmonicAndVanishOnTheSides) {
  const Field s = corner_sine(corner, 2.0 / 3);
  EXPECT_NEAR(value_at(laplacian(s, 2), polar(0.4, 2)), 0, 1e-12);
  EXPECT_NEAR(value_at(s, polar(0.7, 0)), 0, 1e-15);
  EXPECT_NEAR(value_at(s, polar(0.7, 1.5 * pi)), 0, 1e-15);
}

TEST(CornerFunctions, WhatIsNoCornerIsRefused) {
  EXPECT_THROW(corner_sine({{}, 0, 0}, 1), InvalidArgument);
  EXPECT_THROW(corner_sine({{}, 0, 7}, 1), InvalidArgument);
  EXPECT_THROW(corner_cosine({{}, 0, 1}, 0), InvalidArgument);
}

TEST(CrackFunction, IsTheOpeningOfAStraightCrack) {
  // The crack is the negative x axis: λ = −x, γ = y.
  const Field chi = crack_function(y, -x);
  for (double r = 0.05; r < 2; r *= 2)
    for (double theta = -3.1; theta < 3.13; theta += 0.17)
      EXPECT_NEAR(value_at(chi, {r * std::cos(theta), r * std::sin(theta)}),
                  std::sqrt(r) * std::sin(theta / 2), 1e-15);
}

TEST(CrackFunction, JumpsAcrossTheCrackAndNowhereElse) {
  // Two tips, at (±1, 0).
  const Field chi = crack_function(y, (1 - x * x) / 2);
  for (double a = -0.9; a < 1; a += 0.3) {
    const double upper = value_at(chi, {a, 1e-14}), lower = value_at(chi, {a, -1e-14});
    EXPECT_NEAR(upper, std::sqrt((1 - a * a) / 2), 1e-12);
    EXPECT_NEAR(upper + lower, 0, 1e-12);
    EXPECT_EQ(value_at(chi, {a, 0}) > 0, true) << "the side γ > 0";
  }
  for (const double a : {-2.0, -1.01, 1.01, 3.0}) {
    EXPECT_NEAR(value_at(chi, {a, 1e-14}) - value_at(chi, {a, -1e-14}), 0, 1e-12);
    EXPECT_EQ(value_at(chi, {a, 0}), 0);
  }
}

TEST(CrackFunction, MultipliesAnUndeterminedFunction) {
  const Structure u = cracked(y, -x);
  ASSERT_EQ(u.terms().size(), 2u);
  EXPECT_EQ(value_at(u.terms()[0].coefficient, {-1, 0.5}), 1);
  EXPECT_GT(value_at(u.terms()[1].coefficient, {-1, 0.5}), 0.5);
}

TEST(Enriched, ConditionsHoldThroughTheFactor) {
  const Structure u =
      enriched(x + (1 - y) * psi, 1 - y, corner_sine(corner, 0.5), Structure::undetermined(1));
  EXPECT_EQ(u.unknown_count(), 2);
  for (const auto& term : u.terms()) EXPECT_EQ(value_at(term.coefficient, {0.3, 1}), 0);
}

TEST(Windowed, IsSmoothAcrossItsEdgeUpToItsOrderAndNothingBeyond) {
  const Field window = (0.25 - x * x - y * y);
  for (int m = 0; m <= 3; ++m) {
    const Structure u = windowed(psi, 1.0, window, m, Structure::undetermined(1));
    const Field amplitude = u.terms()[1].coefficient;
    EXPECT_EQ(value_at(amplitude, {0.6, 0.1}), 0);
    EXPECT_NEAR(value_at(amplitude, {0.3, 0}), std::pow(0.16, m + 1), 1e-15);
    const PointJet inside = evaluate(amplitude, {0.5 - 1e-12, 0}, m + 1, 2);
    for (int k = 0; k <= m; ++k) EXPECT_NEAR(inside.derivative(k), 0, 1e-9) << k << " of " << m;
    EXPECT_GT(std::fabs(inside.derivative(m + 1)), 0.5);
  }
  EXPECT_THROW(windowed(psi, 1.0, window, -1, psi), InvalidArgument);
}

}  // namespace
}  // namespace rfm
