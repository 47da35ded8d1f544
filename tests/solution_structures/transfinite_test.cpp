#include "solution_structures/transfinite.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "core/error.hpp"
#include "core/evaluate.hpp"

using namespace rfm;

namespace {

const Field x = x_coordinate(), y = y_coordinate();
// Three disjoint sets: the unit circle, a small circle, the point (0.5, 0).
const Field outer = (1 - x * x - y * y) / 2;
const Field inner = (pow(x + 0.4, 2) + y * y - 0.04) / 0.4;
const Field spot = hypot(x - 0.5, y);

TEST(TransfiniteInterpolant, EqualsEachDatumOnItsSet) {
  const Field g =
      transfinite_interpolant({{sin(3 * x), outer}, {exp(y), inner}, {Field(5.0), spot}});
  for (const double t : {0.2, 1.9, 3.3, 5.0}) {
    EXPECT_NEAR(value_at(g, {std::cos(t), std::sin(t), 0}), std::sin(3 * std::cos(t)), 1e-14);
    EXPECT_NEAR(value_at(g, {-0.4 + 0.2 * std::cos(t), 0.2 * std::sin(t), 0}),
                std::exp(0.2 * std::sin(t)), 1e-14);
  }
  EXPECT_NEAR(value_at(g, {0.5, 0, 0}), 5, 1e-14);
}

TEST(TransfiniteInterpolant, ExponentTwoKeepsFirstDerivativesOfTheDatum) {
  const Field g = transfinite_interpolant({{sin(3 * x), outer, 2}, {exp(y), inner, 2}});
  const Point on_outer{std::cos(1.1), std::sin(1.1), 0};
  const PointJet jet = evaluate(g, on_outer, 1, 2);
  EXPECT_NEAR(jet.derivative(1, 0), 3 * std::cos(3 * on_outer[0]), 1e-13);
  EXPECT_NEAR(jet.derivative(0, 1), 0, 1e-13);
  // With exponent 1 they are lost: the test above could fail.
  const PointJet first =
      evaluate(transfinite_interpolant({{sin(3 * x), outer}, {exp(y), inner}}), on_outer, 1, 2);
  EXPECT_GT(std::abs(first.derivative(0, 1)), 1e-3);
}

TEST(TransfiniteInterpolant, LiesBetweenConstantData) {
  const Field g = transfinite_interpolant({{Field(1.0), outer}, {Field(2.0), inner}});
  for (const double r : {0.3, 0.6, 0.9}) {
    const double value = value_at(g, {0, r, 0});
    EXPECT_GT(value, 1);
    EXPECT_LT(value, 2);
  }
}

TEST(TransfiniteInterpolant, OneDatumIsTheInterpolantAndNoneIsRefused) {
  const Field datum = sin(x);
  EXPECT_TRUE(transfinite_interpolant({{datum, outer}}).same_as(datum));
  EXPECT_THROW(transfinite_interpolant({}), InvalidArgument);
}

}  // namespace
