#include "core/interval.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <numbers>

namespace rfm {
namespace {

constexpr double pi = std::numbers::pi, infinity = INFINITY;
constexpr double denormal = std::numeric_limits<double>::denorm_min();

// Equal, or nearer than a few ulp: infinite ends have no difference.
void expect_end(double found, double expected) {
  if (std::isinf(expected))
    EXPECT_EQ(found, expected);
  else
    EXPECT_NEAR(found, expected, 4e-15 * (1 + std::fabs(expected)));
}

// The range up to a few ulp, outwards.
void expect_range(const Interval& found, double low, double high) {
  EXPECT_LE(found.low, low);
  EXPECT_GE(found.high, high);
  expect_end(found.low, low);
  expect_end(found.high, high);
}

TEST(Interval, KnowsItsSizes) {
  const Interval a(-3, 1);
  EXPECT_EQ(a.middle(), -1);
  EXPECT_EQ(a.radius(), 2);
  EXPECT_EQ(a.width(), 4);
  EXPECT_EQ(a.magnitude(), 3);
  EXPECT_EQ(a.mignitude(), 0);
  EXPECT_EQ(Interval(2, 5).mignitude(), 2);
  EXPECT_EQ(Interval(-5, -2).mignitude(), 2);
  EXPECT_TRUE(a.contains(0) && !a.excludes_zero());
  EXPECT_TRUE(Interval(denormal, 1).excludes_zero());
}

TEST(Interval, ArithmeticIsTheRangeOverAllSigns) {
  const Interval a(-1, 2), b(3, 4), c(-5, -0.5), d(-1, 3);
  expect_range(a + b, 2, 6);
  expect_range(a - b, -5, -1);
  expect_range(a * b, -4, 8);
  expect_range(a * c, -10, 5);
  expect_range(a * d, -3, 6);
  expect_range(c * c, 0.25, 25);
  expect_range(a / b, -1.0 / 3, 2.0 / 3);
  expect_range(b / c, -8, -0.6);
  expect_range(b / Interval(0, 2), -infinity, infinity);  // 3 / −0 = −∞
  expect_range(b / Interval(-2, 0), -infinity, infinity);
  EXPECT_EQ((b / a).low, -infinity);
  EXPECT_EQ((b / a).high, infinity);
}

TEST(Interval, RoundingIsEnclosed) {
  // 0.1 + 0.2 and 0.1 · 3 are not doubles.
  EXPECT_LT((Interval(0.1) + Interval(0.2)).low, (Interval(0.1) + Interval(0.2)).high);
  const Interval third = Interval(1) / Interval(3), one = third * Interval(3);
  EXPECT_TRUE(one.low < 1 && 1 < one.high);
  EXPECT_LT(one.width(), 2e-15);
}

TEST(Interval, ExactZerosStayExact) {
  const Interval zero, a(-2, 3);
  EXPECT_TRUE((zero * a).is_zero());
  EXPECT_TRUE((zero * Interval::entire()).is_zero());
  EXPECT_TRUE((zero + zero).is_zero());
  EXPECT_TRUE((zero / Interval(1, 2)).is_zero());
  EXPECT_TRUE(square(zero).is_zero());
  EXPECT_TRUE(integer_power(zero, 3).is_zero());
  EXPECT_TRUE(sin(zero).is_zero() && sinh(zero).is_zero() && erf(zero).is_zero());
  EXPECT_EQ((a + zero).low, a.low);
  EXPECT_EQ((a - zero).high, a.high);
}

TEST(Interval, UnderflowIsNotAnExactZero) {
  const Interval tiny(1e-200, 2e-200), either(-1e-200, 0);
  for (const Interval& result : {square(tiny), tiny * tiny, exp(Interval(-1001, -1000)),
                                 integer_power(tiny, 3), power(tiny, 2.5)}) {
    EXPECT_FALSE(result.is_zero());
    EXPECT_EQ(result.low, 0);
    EXPECT_GT(result.high, 0);
    EXPECT_LT(result.high, 1e-300);
  }
  EXPECT_LT((Interval(0, 1e-200) * either).low, 0);
  EXPECT_EQ((Interval(0, 1e-200) * either).high, 0);
  EXPECT_LT(integer_power(Interval(-1e-200), 3).low, 0);
}

TEST(Interval, OverflowIsBeyondTheLargestNumber) {
  const Interval huge(1e200, 1e300), product = huge * huge;
  EXPECT_EQ(product.low, std::numeric_limits<double>::max());
  EXPECT_EQ(product.high, infinity);
  EXPECT_EQ(exp(Interval(1000)).low, std::numeric_limits<double>::max());
  EXPECT_EQ((Interval(1, infinity) - Interval(1, infinity)).low, -infinity);
}

TEST(Interval, SquaresAreNotNegative) {
  expect_range(square(Interval(-1, 2)), 0, 4);
  EXPECT_EQ(square(Interval(-1, 2)).low, 0);
  expect_range(square(Interval(-3, -2)), 4, 9);
  expect_range(integer_power(Interval(-2, 1), 4), 0, 16);
  expect_range(integer_power(Interval(-2, 1), 3), -8, 1);
  expect_range(integer_power(Interval(2, 4), -2), 1.0 / 16, 0.25);
  expect_range(integer_power(Interval(-2, 0), -2), 0.25, infinity);
  expect_range(integer_power(Interval(-2, 0), -3), -infinity, infinity);
}

TEST(Interval, SineAndCosineFindTheirExtremesInside) {
  expect_range(sin(Interval(0.1, 0.2)), std::sin(0.1), std::sin(0.2));
  expect_range(sin(Interval(1, 2)), std::sin(1), 1);
  expect_range(sin(Interval(4, 5)), -1, std::sin(4));
  expect_range(sin(Interval(1, 5)), -1, 1);
  expect_range(cos(Interval(-0.1, 0.2)), std::cos(0.2), 1);
  expect_range(cos(Interval(3, 4)), -1, std::cos(4));
  // The end as rounded: cos(0.2) differs from its cosine by 6e-15.
  const double beyond = 100 * pi + 0.2;
  expect_range(cos(Interval(100 * pi - 0.1, beyond)), std::cos(beyond), 1);
  expect_range(sin(Interval(0, 100)), -1, 1);
  expect_range(cos(Interval(1e300)), -1, 1);
  EXPECT_EQ(sin(Interval(1, 2)).high, 1);
}

TEST(Interval, TangentIsUnboundedAcrossItsPoles) {
  expect_range(tan(Interval(-1, 1.2)), std::tan(-1), std::tan(1.2));
  expect_range(tan(Interval(2, 4)), std::tan(2), std::tan(4));
  EXPECT_EQ(tan(Interval(1, 2)).high, infinity);
  EXPECT_EQ(tan(Interval(1, 2)).low, -infinity);
}

TEST(Interval, MonotonicFunctionsTakeTheirEnds) {
  const Interval a(0.25, 0.75);
  expect_range(sqrt(a), 0.5, std::sqrt(0.75));
  expect_range(cbrt(Interval(-8, 27)), -2, 3);
  expect_range(exp(Interval(-1, 1)), std::exp(-1), std::exp(1));
  expect_range(log(a), std::log(0.25), std::log(0.75));
  expect_range(asin(a), std::asin(0.25), std::asin(0.75));
  expect_range(acos(a), std::acos(0.75), std::acos(0.25));
  expect_range(atan(Interval(-1, infinity)), -pi / 4, pi / 2);
  expect_range(sinh(a), std::sinh(0.25), std::sinh(0.75));
  expect_range(cosh(Interval(-1, 0.5)), 1, std::cosh(1));
  expect_range(tanh(a), std::tanh(0.25), std::tanh(0.75));
  expect_range(asinh(a), std::asinh(0.25), std::asinh(0.75));
  expect_range(erf(a), std::erf(0.25), std::erf(0.75));
  expect_range(power(a, -0.5), 1 / std::sqrt(0.75), 2);
  expect_range(abs(Interval(-2, 1)), 0, 2);
  expect_range(floor(Interval(-0.5, 1.5)), -1, 1);
  expect_range(hypot(Interval(-3, 1), Interval(4)), 4, 5);
}

TEST(Interval, PolarAngleKnowsQuadrantsAndTheCut) {
  expect_range(atan2(Interval(1, 2), Interval(1, 2)), std::atan2(1, 2), std::atan2(2, 1));
  expect_range(atan2(Interval(1, 2), Interval(-2, 2)), std::atan2(1, 2), std::atan2(1, -2));
  expect_range(atan2(Interval(-2, -1), Interval(-2, -1)), std::atan2(-1, -2), std::atan2(-2, -1));
  expect_range(atan2(Interval(-1, 1), Interval(1, 2)), -pi / 4, pi / 4);
  expect_range(atan2(Interval(-1, 1), Interval(-2, -1)), -pi, pi);
  expect_range(atan2(Interval(0), Interval(-1)), -pi, pi);  // of −0 it is −π
  expect_range(atan2(Interval(-1, 1), Interval(-1, 1)), -pi, pi);
}

TEST(Interval, NothingIsKnownWhereAFunctionMayBeNoNumber) {
  for (const Interval& nothing :
       {sqrt(Interval(-1, 4)), log(Interval(-1, 1)), asin(Interval(-2, 0)), acos(Interval(0, 2)),
        power(Interval(-1, 4), 0.5), sqrt(Interval(-2, -1)), log(Interval(-2, -1)),
        asin(Interval(2, 3)), acos(Interval(-3, -2)), power(Interval(-2, -1), 0.5)}) {
    EXPECT_EQ(nothing.low, -infinity);
    EXPECT_EQ(nothing.high, infinity);
  }
  // Rounding of the argument does not count.
  expect_range(sqrt(Interval(-1e-16, 4)), 0, 2);
  expect_range(log(Interval(-1e-16, 1)), -infinity, 0);
  expect_range(asin(Interval(-1 - 1e-15, 0)), -pi / 2, 0);
  expect_range(power(Interval(-1e-16, 4), 0.5), 0, 2);
}

TEST(Interval, ComparisonsAreThreeValued) {
  const Interval low(0, 1), high(2, 3), between(0.5, 2.5);
  EXPECT_EQ(less(low, high), Truth::yes);
  EXPECT_EQ(less(high, low), Truth::no);
  EXPECT_EQ(less(low, between), Truth::unknown);
  EXPECT_EQ(less(low, Interval(1, 2)), Truth::unknown);
  EXPECT_EQ(less_equal(low, Interval(1, 2)), Truth::yes);
  EXPECT_EQ(equal(low, high), Truth::no);
  EXPECT_EQ(equal(Interval(2), Interval(2)), Truth::yes);
  EXPECT_EQ(equal(low, between), Truth::unknown);
  EXPECT_EQ(select(Truth::unknown, low, high).high, 3);
  EXPECT_EQ(select(Truth::yes, low, high).high, 1);
}

TEST(Interval, IntersectionAndHull) {
  EXPECT_EQ(intersection(Interval(0, 2), Interval(1, 3)).low, 1);
  EXPECT_EQ(intersection(Interval(0, 2), Interval(1, 3)).high, 2);
  EXPECT_EQ(hull(Interval(0, 1), Interval(3, 4)).low, 0);
  EXPECT_EQ(hull(Interval(0, 1), Interval(3, 4)).high, 4);
  // Disjoint by rounding only: the narrower is kept.
  EXPECT_EQ(intersection(Interval(0, 1), Interval(1 + 1e-15, 3)).high, 1);
}

}  // namespace
}  // namespace rfm
