#include <gmock/gmock.h>

#include <functional>
#include <numbers>
#include <random>

#include "core/box.hpp"
#include "tests/core/operation_rows.hpp"

// That the margins of bounds are wide enough, next to where they are tight: intervals of one point
// against long double, and boxes of every width around singular points and at the ends of the
// number line.
namespace rfm {
namespace {

constexpr double infinity = INFINITY, pi = std::numbers::pi;

struct Function {
  const char* name;
  std::function<Interval(const Interval&)> bounds;
  std::function<long double(long double)> exact;
  double low, high;  // of the arguments, which are taken at all scales if low is 0
};

const std::vector<Function>& functions() {
#define RFM_FUNCTION(f, low, high)                                                                 \
  Function {                                                                                       \
#f, [](const Interval& a) { return f(a); }, [](long double x) { return std::f(x); }, low, high \
  }
  static const std::vector<Function> all = {
      RFM_FUNCTION(sqrt, 0, 1e300), RFM_FUNCTION(cbrt, 0, 1e300),  RFM_FUNCTION(exp, -745, 709),
      RFM_FUNCTION(exp, 0, 700),    RFM_FUNCTION(log, 0, 1e300),   RFM_FUNCTION(log, 0.5, 2),
      RFM_FUNCTION(sin, 0, 1e15),   RFM_FUNCTION(cos, 0, 1e15),    RFM_FUNCTION(tan, 0, 1e15),
      RFM_FUNCTION(sin, -7, 7),     RFM_FUNCTION(cos, -7, 7),      RFM_FUNCTION(tan, -7, 7),
      RFM_FUNCTION(asin, -1, 1),    RFM_FUNCTION(acos, -1, 1),     RFM_FUNCTION(atan, 0, 1e300),
      RFM_FUNCTION(asin, 0, 1),     RFM_FUNCTION(sinh, 0, 709),    RFM_FUNCTION(sinh, -3, 3),
      RFM_FUNCTION(cosh, 0, 709),   RFM_FUNCTION(cosh, -3, 3),     RFM_FUNCTION(tanh, 0, 30),
      RFM_FUNCTION(tanh, -1, 1),    RFM_FUNCTION(asinh, 0, 1e300), RFM_FUNCTION(asinh, -3, 3),
      RFM_FUNCTION(erf, 0, 7),      RFM_FUNCTION(erf, -3, 3),
  };
#undef RFM_FUNCTION
  return all;
}

// Points of which the images lie inside their bounds, and not nearer to an end than half of what
// is documented would bring them if it were twice as large.
void expect_points_inside(int count) {
  std::mt19937_64 generator(17);
  std::uniform_real_distribution<double> unit(0, 1);
  for (const Function& function : functions())
    for (int i = 0; i < count; ++i) {
      double x = function.low + unit(generator) * (function.high - function.low);
      if (function.low == 0) x = function.high * std::pow(2, -1022 * std::pow(unit(generator), 4));
      const Interval bounds = function.bounds(x);
      const long double exact = function.exact(x);
      ASSERT_TRUE(bounds.low <= exact && exact <= bounds.high)
          << function.name << " at " << testing::PrintToString(x);
      // Far from zero a sine near its extreme is not told from the extreme.
      if (function.high == 1e15 && x > 1e6) continue;
      ASSERT_LE(bounds.width(), 0x1p-47 * std::fabs(exact) + 1e-322) << function.name;
    }
}

TEST(BoundMargins, FunctionsAtPointsAreInside) { expect_points_inside(5000); }
TEST(LongBoundMargins, FunctionsAtPointsAreInside) { expect_points_inside(2000000); }

TEST(BoundMargins, BasicOperationsAreInsideAtEveryScale) {
  std::mt19937_64 generator(19);
  std::uniform_real_distribution<double> mantissa(1, 2);
  std::uniform_int_distribution<int> exponent(-1074, 1023), near(-30, 30);
  for (int i = 0; i < 200000; ++i) {
    const bool any_scale = i % 2 == 0;
    const auto number = [&] {
      return (generator() % 2 ? 1 : -1) *
             std::ldexp(mantissa(generator), any_scale ? exponent(generator) : near(generator));
    };
    const double a = number(), b = number();
    const long double p = a, q = b;
    const auto inside = [&](const Interval& bounds, long double exact, const char* operation) {
      ASSERT_TRUE(bounds.low <= exact && exact <= bounds.high)
          << a << operation << b << ": " << bounds.low << ", " << bounds.high;
    };
    inside(Interval(a) + Interval(b), p + q, "+");
    inside(Interval(a) - Interval(b), p - q, "-");
    inside(Interval(a) * Interval(b), p * q, "*");
    inside(Interval(a) / Interval(b), p / q, "/");
    inside(square(Interval(a)), p * p, "squared");
    inside(hypot(Interval(a), Interval(b)), std::hypot(p, q), "hypot");
    inside(atan2(Interval(a), Interval(b)), std::atan2(p, q), "atan2");
    inside(integer_power(Interval(a), 3), p * p * p, "cubed");
    inside(power(Interval(std::fabs(a)), 1.7), std::pow(std::fabs(p), 1.7L + (1.7 - 1.7L)), "pow");
  }
}

TEST(BoundMargins, AnglesThatUnderflowAreNotExactlyZero) {
  EXPECT_FALSE(atan2(Interval(1e-200), Interval(1e200)).is_zero());
  EXPECT_FALSE(atan2(Interval(-1e-200), Interval(1e200)).is_zero());
  EXPECT_TRUE(atan2(Interval(0), Interval(1e200)).is_zero());
}

TEST(BoundMargins, NothingIsKnownOfANegativePowerOfZero) {
  EXPECT_EQ(power(Interval(0), -1.3).low, -infinity);
  EXPECT_EQ(power(Interval(0), -1.3).high, infinity);
}

// Every operation over boxes of every width.

class EveryBound : public testing::TestWithParam<Row> {};
INSTANTIATE_TEST_SUITE_P(OperationTable, EveryBound, testing::ValuesIn(all_rows()),
                         [](const auto& info) { return info.param.identifier; });

using Reference = Jet<long double, 2, 1>;

Interval range_of(const Interval& a) { return a; }
Interval range_of(const TaylorBound& a) { return a.range; }

template <class T>
Jet<T, 2, 1> argument_over(const Box& box, int axis) {
  if constexpr (std::is_same_v<T, TaylorBound>)
    return Jet<T, 2, 1>::variable(axis, TaylorBound::coordinate(box.interval(axis), axis));
  else
    return Jet<T, 2, 1>::variable(axis, box.interval(axis));
}

template <class T>
void expect_bounds_hold(const Row& row, const Box& box, std::mt19937_64& generator, int samples) {
  const TaylorBound::Frame frame(
      {0.5 * box.length(0) * (1 + 1e-15), 0.5 * box.length(1) * (1 + 1e-15), 0});
  const auto bounds = row(argument_over<T>(box, 0), argument_over<T>(box, 1), Jet<T, 2, 1>(0.75));
  std::uniform_real_distribution<double> unit(0, 1);
  for (const T& coefficient : bounds.c) {
    const Interval range = range_of(coefficient);
    ASSERT_TRUE(range.low <= range.high)
        << row.identifier << ": " << range.low << ", " << range.high;  // no NaN
  }
  for (int i = 0; i < samples; ++i) {
    std::array<double, 2> at;
    for (int axis = 0; axis < 2; ++axis) {
      // Corners, points at all distances from a side, and points between.
      const double low = box.low[axis], high = box.high[axis];
      const double length = std::isfinite(high - low) ? high - low : 1e300;
      const double t = i < 4        ? (i >> axis & 1)
                       : i % 2 == 0 ? unit(generator)
                                    : std::pow(10, -18 * unit(generator));
      at[axis] = generator() % 2 ? low + t * length : high - t * length;
      if (!std::isfinite(at[axis]))
        at[axis] = std::isfinite(low) ? low + t : std::isfinite(high) ? high - t : t;
      at[axis] = std::clamp(at[axis], low, high);
    }
    const Reference exact =
        row(Reference::variable(0, at[0]), Reference::variable(1, at[1]), Reference(0.75));
    if (!std::isfinite(exact.value())) continue;
    for (int k = 0; k < 3; ++k) {
      const Interval range = range_of(bounds.c[k]);
      if (std::isnan(exact.c[k])) continue;
      ASSERT_TRUE(range.low <= exact.c[k] && exact.c[k] <= range.high)
          << row.identifier << ": coefficient " << k << " = " << double(exact.c[k]) << " at "
          << at[0] << ", " << at[1] << " is not in [" << range.low << ", " << range.high
          << "] over [" << box.low[0] << ", " << box.high[0] << "] x [" << box.low[1] << ", "
          << box.high[1] << "]";
    }
  }
}

void expect_bounds_hold(const Row& row, int boxes) {
  const double special[] = {0, 1, -1, 2, pi / 2, -pi, 100 * pi, 1e-310, -1e-160, 49, 1e10, -1e15};
  std::mt19937_64 generator(23);
  std::uniform_real_distribution<double> uniform(-3, 3), exponent(-17, 6);
  for (int i = 0; i < boxes && !testing::Test::HasFailure(); ++i) {
    Box box;
    for (int axis = 0; axis < 2; ++axis) {
      const double center = generator() % 3 ? special[generator() % 12] : uniform(generator);
      const double width = generator() % 8 ? std::pow(10, exponent(generator)) : 0;
      const int side = generator() % 3;  // the special point on a side or inside
      box.low[axis] = center - (side == 0 ? 0 : width);
      box.high[axis] = center + (side == 1 ? 0 : width);
      if (generator() % 16 == 0) box.high[axis] = infinity;
      if (generator() % 16 == 0) box.low[axis] = -infinity;
    }
    expect_bounds_hold<Interval>(row, box, generator, 24);
    if (std::isfinite(box.length(0)) && std::isfinite(box.length(1)))
      expect_bounds_hold<TaylorBound>(row, box, generator, 24);
  }
}

TEST_P(EveryBound, HoldsOverBoxesOfEveryWidth) { expect_bounds_hold(GetParam(), 500); }
TEST(LongBoundMargins, EveryBoundHoldsOverBoxesOfEveryWidth) {
  for (const Row& row : all_rows()) expect_bounds_hold(row, 50000);
}

// The rules share their constants with the reference above; here derivatives are written out.
TEST(BoundMargins, SlopesOfRootsAndPowersAreThoseOfClosedForms) {
  std::mt19937_64 generator(29);
  std::uniform_real_distribution<double> scale(-200, 200);
  for (int i = 0; i < 20000; ++i) {
    const double x = std::pow(2, scale(generator));
    const auto a = Jet<Interval, 1, 1>::variable(0, Interval(x));
    const auto inside = [&](const Interval& bounds, long double exact, const char* name) {
      ASSERT_TRUE(bounds.low <= exact && exact <= bounds.high) << name << " at " << x;
    };
    const long double root = std::cbrt(static_cast<long double>(x));
    inside(cbrt(a).c[1], 1 / (3 * root * root), "cbrt");
    inside(sqrt(a).c[1], 0.5L / std::sqrt(static_cast<long double>(x)), "sqrt");
    for (const double e : {1.7, -1.3, 0.1, 2.5})
      inside(real_power(a, e).c[1],
             static_cast<long double>(e) *
                 std::pow(static_cast<long double>(x), static_cast<long double>(e) - 1),
             "power");
    inside(erf(a).c[1],
           2 * std::numbers::inv_sqrtpi_v<long double> *
               std::exp(-static_cast<long double>(x) * static_cast<long double>(x)),
           "erf");
  }
}

}  // namespace
}  // namespace rfm
