#include "core/taylor_bound.hpp"

#include <gmock/gmock.h>

#include <cmath>

#include "core/operation_rules.hpp"
#include "core/tape.hpp"

namespace rfm {
namespace {

// The conformance of every operation is tested in operations_test.cpp; here, what makes the models
// good and what keeps them sound.

std::array<TaylorBound, 2> coordinates_over(const Interval& x, const Interval& y) {
  return {TaylorBound::coordinate(x, 0), TaylorBound::coordinate(y, 1)};
}

TEST(TaylorBound, AffineFunctionsAreExact) {
  const TaylorBound::Frame frame({0.5, 0.25, 0});
  const auto [x, y] = coordinates_over({0, 1}, {1, 1.5});
  const TaylorBound f = TaylorBound(2.0) * x - y + TaylorBound(3.0);
  EXPECT_NEAR(f.range.low, 1.5, 1e-14);
  EXPECT_NEAR(f.range.high, 4, 1e-14);
  EXPECT_NEAR(f.slope[0], 2, 1e-15);
  EXPECT_NEAR(f.slope[1], -1, 1e-15);
  // Nothing but the rounding margin, 2e-15 of the size after each of three operations.
  EXPECT_LT(f.error, 3 * 4 * 2e-15);
}

TEST(TaylorBound, DependenceIsNotLost) {
  // Plain intervals give [−1, 1] for x − x and [0, 1] for x (1 − x) over [0, 1].
  const TaylorBound::Frame frame({0.5, 0, 0});
  const TaylorBound x = TaylorBound::coordinate({0, 1}, 0);
  EXPECT_NEAR((x - x).range.width(), 0, 1e-14);
  EXPECT_LT((x * (TaylorBound(1.0) - x)).range.high, 0.5 + 1e-12);
}

TEST(TaylorBound, BranchesThatAreUndecidedKeepTheRangeOfTheWhole) {
  // The union of both branches would be [−1, 2], [1, 3] ∪ [2, 5] and the same.
  const auto expect = [](const Interval& found, double low, double high) {
    EXPECT_EQ(found.low, low);
    EXPECT_EQ(found.high, high);
  };
  using Plain = Jet<Interval, 1, 0>;
  using Model = Jet<TaylorBound, 1, 0>;
  const Plain x = Plain::constant({-1, 2}), p = Plain::constant({1, 4}),
              q = Plain::constant({2, 3});
  expect(abs(x).value(), 0, 2);
  expect(min(p, q).value(), 1, 3);
  expect(max(p, q).value(), 2, 4);
  const TaylorBound::Frame frame({2, 0, 0});
  const Model y = Model::constant(TaylorBound::coordinate({-1, 2}, 0));
  EXPECT_EQ(abs(y).value().range.low, 0);
  EXPECT_EQ(max(y, Model::constant(TaylorBound(0.5))).value().range.low, 0.5);
}

TEST(TaylorBound, AModelOutsideItsOwnRangeIsGivenUp) {
  // Over a wide box the model of an exponential has its middle far above every value; logarithms
  // and roots must not be expanded there.
  const TaylorBound::Frame frame({10, 0, 0});
  const TaylorBound x = TaylorBound::coordinate({-10, 10}, 0), e = exp(x);
  EXPECT_TRUE(e.range.contains(e.value));
  const TaylorBound back = log(e);
  EXPECT_LE(back.range.low, -10);
  EXPECT_GE(back.range.high, 10);
  EXPECT_LT(back.range.width(), 40);
}

TEST(TaylorBound, TouchingASingularityIsNotSmooth) {
  const TaylorBound::Frame frame({1, 0, 0});
  const TaylorBound x = TaylorBound::coordinate({-1, 1}, 0), positive = x + TaylorBound(1.5);
  for (const TaylorBound& rough :
       {sqrt(square(x)), cbrt(x), TaylorBound(1.0) / x, log(x + TaylorBound(1.0)), power(x, 0.5),
        floor(x), asin(x), tan(x + x), atan2(TaylorBound(0.0), x)})
    EXPECT_FALSE(rough.smooth);
  for (const TaylorBound& smooth : {sqrt(positive), cbrt(positive), TaylorBound(1.0) / positive,
                                    log(positive), power(positive, 0.5), sin(x), atan(x)})
    EXPECT_TRUE(smooth.smooth);
  EXPECT_FALSE(sin(sqrt(square(x))).smooth);  // and what is made of it is not, either
}

TEST(TaylorBound, SlopesThatUnderflowAreNotLostOverLargeBoxes) {
  // The slope of x is 1e-350 in the first two; that of x^-3 is 3e-348.
  const Field x = x_coordinate(), y = y_coordinate();
  const auto expect = [](const Field& f, const Box& box) {
    const Tape tape({f}, {1}, 2);
    const FunctionBounds bounds = tape.bounds(box);
    for (const double u : {0.0, 0.3, 1.0})
      for (const double v : {0.0, 0.6, 1.0}) {
        const Point at{std::lerp(box.low[0], box.high[0], u),
                       std::lerp(box.low[1], box.high[1], v)};
        Point gradient;
        const double value = tape.value_and_gradient(at, gradient);
        EXPECT_LE(bounds.value.low, value);
        EXPECT_GE(bounds.value.high, value);
        for (int axis = 0; axis < 2; ++axis) {
          EXPECT_LE(bounds.gradient[axis].low, gradient[axis]);
          EXPECT_GE(bounds.gradient[axis].high, gradient[axis]);
        }
      }
  };
  expect(1e200 * (y * (1e-150 * x)), {2, {-1e150, 1e-200}, {1e150, 2e-200}});
  expect(y * (1e-20 * x), {2, {-1e20, 1e-300}, {1e20, 2e-300}});
  expect(min(1e250 * pow(x, -3), 9), {2, {8.7e86, 0}, {1.3e87, 1}});
}

TEST(TaylorBound, FramesNest) {
  const TaylorBound::Frame outer({1, 0, 0});
  TaylorBound x = TaylorBound::coordinate({-1, 1}, 0);
  {
    const TaylorBound::Frame inner({0.5, 0, 0});
    EXPECT_EQ(x.linear_extent(), 0.5);
  }
  EXPECT_EQ(x.linear_extent(), 1);
}

TEST(TaylorBound, RFunctionsAreBoundedAroundTheirCorner) {
  const TaylorBound::Frame frame({0.1, 0.1, 0});
  const auto over_corner = [](const auto& x, const auto& y) { return r0_conjunction(x, y); };
  using Model = Jet<TaylorBound, 2, 0>;
  const Interval box(-0.1, 0.1);
  const auto [a, b] = coordinates_over(box, box);
  const Interval range = over_corner(Model::constant(a), Model::constant(b)).value().range;
  // x ∧ y takes values from −(2 + √2)/10 to (2 − √2)/10.
  EXPECT_LE(range.low, -0.1 * (2 + std::sqrt(2)));
  EXPECT_GE(range.high, 0.1 * (2 - std::sqrt(2)));
  EXPECT_LT(range.width(), 0.6);
}

TEST(TaylorBound, WholePowersBeyondTheTableOfIntegersKnowNegativeArguments) {
  // 1 − x¹⁰⁰ − y¹⁰⁰ was taken for inside where x < −1.
  const Field x = x_coordinate(), y = y_coordinate();
  for (const double exponent : {65.0, 66.0, 100.0, -65.0, -66.0}) {
    const Tape tape({pow(x, exponent) + y}, {1}, 2);
    for (const double low : {-2.0, -1.1, 0.5, 0.9})
      for (const double width : {0.0, 1e-3, 0.3, 3.0}) {
        const Box box{2, {low, -0.1}, {low + width, 0.2}};
        const auto bounds = tape.bounds(box);
        for (int i = 0; i <= 20; ++i) {
          const double at = low + width * i / 20;
          if (at == 0) continue;
          const double value = std::pow(at, exponent) + 0.2;
          EXPECT_LE(bounds.value.low, value) << exponent << ' ' << low << ' ' << width;
          EXPECT_GE(bounds.value.high, value) << exponent << ' ' << low << ' ' << width;
          const double slope = exponent * std::pow(at, exponent - 1);
          EXPECT_LE(bounds.gradient[0].low, slope) << exponent << ' ' << low << ' ' << width;
          EXPECT_GE(bounds.gradient[0].high, slope) << exponent << ' ' << low << ' ' << width;
        }
      }
  }
}

}  // namespace
}  // namespace rfm
