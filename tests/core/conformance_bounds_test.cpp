#include <gmock/gmock.h>

#include <cmath>
#include <numbers>

#include "core/box.hpp"
#include "core/expression_text.hpp"
#include "core/tape.hpp"
#include "tests/core/conformance_points.hpp"

// Bounds of every row of the table over boxes of every width contain values and gradients at
// samples, as power series of hundreds of digits have them: by intervals and by first-order Taylor
// models.
namespace rfm {
namespace {

class ConformanceOfBounds : public testing::TestWithParam<Row> {};
INSTANTIATE_TEST_SUITE_P(OperationTable, ConformanceOfBounds, testing::ValuesIn(conformance_rows()),
                         [](const auto& info) { return info.param.identifier; });

Interval range_of(const Interval& a) { return a; }
Interval range_of(const TaylorBound& a) { return a.range; }

template <class T>
Jet<T, 3, 1> argument_over(const Box& box, int axis) {
  if constexpr (std::is_same_v<T, TaylorBound>)
    return Jet<T, 3, 1>::variable(axis, TaylorBound::coordinate(box.interval(axis), axis));
  else
    return Jet<T, 3, 1>::variable(axis, box.interval(axis));
}

using Ranges = std::array<Interval, 4>;  // of value and gradient

template <class T>
Ranges bounds_over(const Row& row, const Box& box) {
  std::array<double, maximum_variables> radius{};
  for (int axis = 0; axis < 3; ++axis) {
    const double middle = box.interval(axis).middle();  // of denormals it is an end
    radius[axis] = std::max(box.high[axis] - middle, middle - box.low[axis]) * (1 + 0x1p-50);
  }
  const TaylorBound::Frame frame(radius);
  const auto jet =
      row(argument_over<T>(box, 0), argument_over<T>(box, 1), argument_over<T>(box, 2));
  Ranges ranges;
  for (int k = 0; k < 4; ++k) ranges[k] = range_of(jet.c[k]);
  return ranges;
}

double sample_between(double low, double high, std::mt19937_64& generator) {
  std::uniform_real_distribution<double> unit(0, 1);
  const double t = generator() % 2 ? unit(generator) : std::pow(10, -18 * unit(generator));
  const double at = generator() % 2 ? low + t * (high - low) : high - t * (high - low);
  return std::clamp(at, low, high);
}

// Boxes about nasty points, which lie inside or on a side, and samples in them, corners first.
void expect_bounds_contain(const Row& row, int boxes, int samples) {
  const int arity = find_operation(row.operation)->arity;
  std::mt19937_64 generator(31);
  std::uniform_real_distribution<double> exponent(-17, 2);
  int misses = 0;
  for (const Arguments& center : nasty_arguments(arity, boxes, generator)) {
    Box box;
    box.dimension = 3;
    for (int axis = 0; axis < 3; ++axis) {
      const double width = generator() % 8 ? std::pow(10, exponent(generator)) : 0;
      const double scale = generator() % 2 ? std::max(1.0, std::fabs(center[axis])) : 1;
      box.low[axis] = center[axis] - (generator() % 3 ? scale * width : 0);
      box.high[axis] = center[axis] + (generator() % 3 ? scale * width : 0);
    }
    const Ranges intervals = bounds_over<Interval>(row, box);
    const Ranges models = bounds_over<TaylorBound>(row, box);
    for (int i = 0; i < samples; ++i) {
      Arguments at{};
      for (int axis = 0; axis < 3; ++axis)
        at[axis] = i < 8 ? (i >> axis & 1 ? box.high : box.low)[axis]
                         : sample_between(box.low[axis], box.high[axis], generator);
      const OperationTruth truth = truth_of(row, at, 1);
      if (!truth.is_defined) continue;
      for (int k = 0; k <= arity; ++k) {
        if (!truth.is_known[k] || (k > 0 && !truth.is_smooth)) continue;
        const long double exact = truth.coefficients[k],
                          unsure = std::isfinite(exact) ? 1e-20L * truth.weights[k] : 0;
        for (const Ranges* ranges : {&intervals, &models}) {
          const Interval range = (*ranges)[k];
          if (range.low <= exact + unsure && exact - unsure <= range.high) continue;
          if (++misses > 3) continue;
          ADD_FAILURE() << row.identifier << ", number " << row.number << ": coefficient " << k
                        << " of " << (ranges == &intervals ? "intervals" : "Taylor models") << " ["
                        << testing::PrintToString(range.low) << ", "
                        << testing::PrintToString(range.high) << "] does not contain "
                        << testing::PrintToString(double(exact)) << " at ("
                        << testing::PrintToString(at[0]) << ", " << testing::PrintToString(at[1])
                        << ")";
        }
      }
    }
  }
}

TEST_P(ConformanceOfBounds, IsMetByThreeHundredSamples) {
  expect_bounds_contain(GetParam(), 20, 15);
}

TEST(LongConformanceOfBounds, OfEveryOperationByTenThousandSamples) {
  for (const Row& row : conformance_rows()) expect_bounds_contain(row, 500, 20);
}

// What operations of plain numbers give, infinite values included, lies within the bounds; NaN is
// no value.
void expect_values_within(const Row& row, const Box& box, const std::vector<Arguments>& points) {
  const Interval plain = bounds_over<Interval>(row, box)[0];
  const Interval model = bounds_over<TaylorBound>(row, box)[0];
  using Number = Jet<double, 1, 0>;
  for (const auto& [a, b, c] : points) {
    const double value = row(Number(a), Number(b), Number(c)).value();
    if (std::isnan(value)) continue;
    const double rounding = std::isinf(value) ? 0 : 1e-14 * std::fabs(value);
    for (const Interval& range : {plain, model})
      EXPECT_TRUE(range.low - rounding <= value && value <= range.high + rounding)
          << row.identifier << ", number " << row.number << ": [" << range.low << ", " << range.high
          << "] does not contain " << value << " at (" << a << ", " << b << ") in the box from ("
          << box.low[0] << ", " << box.low[1] << ") to (" << box.high[0] << ", " << box.high[1]
          << ")";
  }
}

// Every box with sides among these numbers, and in it all points with coordinates among them.
void expect_values_within_boxes(const Row& row, const std::vector<double>& numbers) {
  const int arity = find_operation(row.operation)->arity;
  std::vector<std::pair<double, double>> sides;
  for (const double low : numbers)
    for (const double high : numbers)
      if (low <= high) sides.emplace_back(low, high);
  const auto within = [&](const std::pair<double, double>& side) {
    std::vector<double> inside;
    for (const double number : numbers)
      if (side.first <= number && number <= side.second) inside.push_back(number);
    return inside;
  };
  const std::vector<std::pair<double, double>> second =
      arity > 1 ? sides : std::vector<std::pair<double, double>>{{0.5, 0.5}};
  for (const auto& first : sides)
    for (const auto& other : second) {
      Box box;
      box.dimension = 3;
      box.low = {first.first, other.first, 0.5};
      box.high = {first.second, other.second, 0.5};
      std::vector<Arguments> points;
      for (const double a : within(first))
        for (const double b : arity > 1 ? within(other) : std::vector<double>{0.5})
          points.push_back({a, b, 0.5});
      expect_values_within(row, box, points);
    }
}

TEST_P(ConformanceOfBounds, HoldValuesAtPolesAndZerosOfBothSigns) {
  constexpr double pi = std::numbers::pi, tiny = std::numeric_limits<double>::denorm_min();
  expect_values_within_boxes(GetParam(), {-2.5, -1, -tiny, -0.0, 0.0, tiny, 0.5, 1, pi / 2, 1e200});
}

TEST_P(ConformanceOfBounds, HoldValuesAtInfinity) {
  expect_values_within_boxes(GetParam(), {-INFINITY, -1e300, -2.5, -0.0, 0.0, 1, 1e300, INFINITY});
}

TEST(BoundsAtPoles, OfFunctionsOfThemHoldTheirValues) {
  const Field x = x_coordinate(), y = y_coordinate();
  const std::vector<Field> poles{
      1 / x,        1 / sqrt(x),        1 / abs(x),
      pow(x, -3.0), pow(x, -2.0),       pow(x, -0.5),
      log(x),       pow(abs(x), y - 2), 1 / (x * y),
      y / x,        1 / hypot(x, y),    1 / mod(x, 1),
      1 / tan(x),   1 / floor(x),       1 / min(x, y),
      1 / step(-x), 1 / log(x + 1),     x / apply(Operation::r0_conjunction, {x, y})};
  for (const Field& pole : poles)
    for (const Field& f :
         {pole, tanh(pole), atan(pole), min(1, pole), max(-1, pole), exp(pole), sign(pole),
          step(pole), 1 / (1 + pole), apply(Operation::less, {pole, 0}), select(pole, x, pole),
          atan2(pole, y), floor(pole), pow(pole, -1.0)}) {
      const Tape tape({f}, {1}, 2);
      for (const Box& box :
           {Box{2, {-1, -1}, {0, 1}}, Box{2, {0, 0}, {1, 1}}, Box{2, {-1, 0}, {1, 0}},
            Box{2, {-0.0, -1}, {0, -0.0}}, Box{2, {0, 0.5}, {0, 0.5}}}) {
        const Interval plain = tape.value_bounds(box), model = tape.bounds(box).value;
        for (const double a : {box.low[0], box.high[0], 0.0, -0.0})
          for (const double b : {box.low[1], box.high[1], 0.0, -0.0}) {
            const double value = tape.value({a, b});
            if (std::isnan(value) || !(box.low[1] <= b && b <= box.high[1])) continue;
            EXPECT_TRUE(plain.contains(value) && model.contains(value))
                << to_text(f) << " at (" << a << ", " << b << ") is " << value << ", outside of ["
                << plain.low << ", " << plain.high << "] or [" << model.low << ", " << model.high
                << "]";
          }
      }
    }
}

}  // namespace
}  // namespace rfm
