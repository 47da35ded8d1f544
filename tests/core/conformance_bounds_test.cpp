#include <gmock/gmock.h>

#include <cmath>
#include <numbers>

#include "core/box.hpp"
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
  for (int axis = 0; axis < 3; ++axis) radius[axis] = 0.5 * box.length(axis) * (1 + 1e-15);
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

}  // namespace
}  // namespace rfm
