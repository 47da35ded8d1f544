#include "core/coordinate_rounding.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace rfm {
namespace {

// `volatile`, as GCC 12 leaves the last points of a loop over this conversion as they are.
double in_single_precision(double x) {
  const volatile float single = static_cast<float>(x);
  return static_cast<double>(single);
}

std::vector<Point> circle(double scale, double unit) {
  std::vector<Point> points;
  for (int i = 0; i < 20; ++i) {
    const double t = 0.3 * i + 0.1;
    points.push_back({std::round(scale * std::cos(t) / unit) * unit,
                      std::round(scale * std::sin(t) / unit) * unit});
  }
  return points;
}

TEST(CoordinateRounding, IsTheLastDecimalPlaceGiven) {
  for (int power = 2; power <= 11; ++power)
    for (const double scale : {1.0, 1e-6, 2.54e4}) {
      const double unit = std::pow(10.0, std::floor(std::log10(scale)) - power);
      EXPECT_NEAR(coordinate_rounding(circle(scale, unit)), unit, 1e-6 * unit) << power;
    }
  EXPECT_EQ(coordinate_rounding(std::vector<Point>{{1200, 30}, {400, 5}}), 1);
  EXPECT_EQ(coordinate_rounding(std::vector<Point>{{1200, 30}, {400, 50}}), 10);
  EXPECT_EQ(coordinate_rounding(std::vector<Point>{{0, 0}, {0, 0}}), 0);
}

TEST(CoordinateRounding, IsThatOfSinglePrecisionWhereAllNumbersAre) {
  std::vector<Point> points = circle(1, 1e-17);
  EXPECT_LT(coordinate_rounding(points), 1e-14);
  for (Point& p : points)
    for (int axis = 0; axis < 2; ++axis) p[axis] = in_single_precision(p[axis]);
  EXPECT_NEAR(coordinate_rounding(points), 0x1p-24, 0x1p-26);
  for (Point& p : points)  // printed with nine digits
    for (int axis = 0; axis < 2; ++axis) p[axis] = std::round(p[axis] * 1e9) / 1e9;
  EXPECT_NEAR(coordinate_rounding(points), 0x1p-24, 0x1p-26);
}

}  // namespace
}  // namespace rfm
