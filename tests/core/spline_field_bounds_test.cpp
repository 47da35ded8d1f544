#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "core/spline_field.hpp"

namespace rfm {
namespace {

const Grid grid({2, {-1, 0}, {2, 1}}, {6, 4, 1});

SplineField random_spline(int degree, unsigned seed) {
  std::mt19937 generator(seed);
  std::uniform_real_distribution<double> uniform(-1, 1);
  std::vector<double> coefficients(
      static_cast<std::size_t>(SplineField::coefficient_count(grid, degree)));
  for (double& c : coefficients) c = uniform(generator);
  return {grid, degree, std::move(coefficients)};
}

TEST(SplineFieldBounds, OfTheWholeGridDoNotExceedTheCoefficients) {
  for (const int degree : {0, 1, 3, 8}) {
    const SplineField spline = random_spline(degree, 7);
    const auto [low, high] = std::ranges::minmax(spline.coefficients());
    const FunctionBounds bounds = spline.bounds(grid.box());
    EXPECT_GE(bounds.value.low, low - 1e-13);
    EXPECT_LE(bounds.value.high, high + 1e-13);
    EXPECT_EQ(bounds.smooth, degree > 1);
  }
}

TEST(SplineFieldBounds, OfPartsOfABoxLieWithinThoseOfTheBox) {
  std::mt19937 generator(8);
  std::uniform_real_distribution<double> uniform(0, 1);
  for (const int degree : {1, 2, 5}) {
    const SplineField spline = random_spline(degree, 9);
    for (int trial = 0; trial < 100; ++trial) {
      Box outer{2, {-1 + 2 * uniform(generator), 0.6 * uniform(generator)}, {}};
      outer.high = {outer.low[0] + 0.9, outer.low[1] + 0.3};
      Box inner = outer;
      for (int axis = 0; axis < 2; ++axis) {
        inner.low[axis] += 0.4 * uniform(generator) * outer.length(axis);
        inner.high[axis] -= 0.4 * uniform(generator) * outer.length(axis);
      }
      const FunctionBounds wide = spline.bounds(outer), narrow = spline.bounds(inner);
      EXPECT_GE(narrow.value.low, wide.value.low - 1e-12);
      EXPECT_LE(narrow.value.high, wide.value.high + 1e-12);
      for (int axis = 0; axis < 2; ++axis) {
        EXPECT_GE(narrow.gradient[axis].low, wide.gradient[axis].low - 1e-11);
        EXPECT_LE(narrow.gradient[axis].high, wide.gradient[axis].high + 1e-11);
      }
    }
  }
}

TEST(SplineFieldBounds, OfAPointAreItsValueUpToRounding) {
  const SplineField spline = random_spline(3, 10);
  const Point point{0.3141, 0.2718};
  const FunctionBounds bounds = spline.bounds({2, point, point});
  double jet[3];
  spline.evaluate({&point[0], &point[1], nullptr}, 1, 2, 1, jet, 1);
  EXPECT_TRUE(bounds.value.contains(jet[0]));
  EXPECT_LT(bounds.value.width(), 1e-13);
  for (int axis = 0; axis < 2; ++axis) {
    EXPECT_TRUE(bounds.gradient[axis].contains(jet[1 + axis]));
    EXPECT_LT(bounds.gradient[axis].width(), 1e-11);
  }
}

TEST(SplineFieldBounds, OfABoxThatReachesOutsideAreUnknown) {
  const SplineField spline = random_spline(2, 11);
  const FunctionBounds bounds = spline.bounds({2, {1.5, 0.5}, {2.1, 0.6}});
  EXPECT_EQ(bounds.value.width(), INFINITY);
  EXPECT_EQ(bounds.gradient[1].width(), INFINITY);
  EXPECT_FALSE(bounds.smooth);
}

}  // namespace
}  // namespace rfm
