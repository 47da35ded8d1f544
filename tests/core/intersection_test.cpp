#include "core/intersection.hpp"

#include <gmock/gmock.h>

#include <cmath>

namespace rfm {
namespace {

const Field x = x_coordinate(), y = y_coordinate(), z = z_coordinate();
const LevelFunction circle(1 - x * x - y * y, 2), line(y - x, 2);

TEST(Intersection, OfALineAndACircleIsExact) {
  const auto point = common_zero(circle, line, {0.9, 0.2});
  ASSERT_TRUE(point);
  EXPECT_NEAR((*point)[0], std::sqrt(0.5), 2e-16);
  EXPECT_NEAR((*point)[1], std::sqrt(0.5), 2e-16);
  const auto other = common_zero(circle, line, {-0.3, -1.2});
  ASSERT_TRUE(other);
  EXPECT_NEAR((*other)[0], -std::sqrt(0.5), 2e-16);
}

TEST(Intersection, InSpaceIsThePointOfTheCurveNearestToFirstOrder) {
  // The sphere and the plane z = 0.6 meet in a circle of radius 0.8.
  const LevelFunction sphere(1 - x * x - y * y - z * z, 3), plane(z - 0.6, 3);
  const auto point = common_zero(sphere, plane, {0.5, 0.5, 0.5});
  ASSERT_TRUE(point);
  EXPECT_NEAR((*point)[2], 0.6, 1e-16);
  EXPECT_NEAR((*point)[0], (*point)[1], 1e-15);
  EXPECT_NEAR(std::hypot((*point)[0], (*point)[1]), 0.8, 1e-15);
}

TEST(Intersection, OfThreeSurfacesIsAPoint) {
  const LevelFunction sphere(1 - x * x - y * y - z * z, 3), plane(z - x, 3), other(y - 0.5, 3);
  const auto point = common_zero(sphere, plane, other, {0.5, 0.5, 0.9});
  ASSERT_TRUE(point);
  EXPECT_NEAR((*point)[0], std::sqrt(0.375), 2e-16);
  EXPECT_NEAR((*point)[1], 0.5, 2e-16);
  EXPECT_NEAR((*point)[2], std::sqrt(0.375), 2e-16);
  EXPECT_FALSE(common_zero(plane, other, LevelFunction(z - x + y, 3), {0, 0, 0}));
}

TEST(Intersection, OfFunctionsThatAreNotPolynomials) {
  const LevelFunction wave(y - sin(x), 2), exponential(y - exp(-x), 2);
  const auto point = common_zero(wave, exponential, {0.5, 0.5});
  ASSERT_TRUE(point);
  EXPECT_NEAR(std::sin((*point)[0]), std::exp(-(*point)[0]), 2e-16);
}

TEST(Intersection, FarFromTheOriginConvergesToo) {
  const LevelFunction far_circle(1e-6 - pow(x - 1000, 2) - pow(y - 1000, 2), 2), far_line(y - x, 2);
  const auto point = common_zero(far_circle, far_line, {1000.001, 1000});
  ASSERT_TRUE(point);
  EXPECT_NEAR((*point)[0] - 1000, 1e-3 * std::sqrt(0.5), 3e-13);
}

TEST(Intersection, TangenciesAndParallelsAreEmpty) {
  EXPECT_FALSE(common_zero(circle, LevelFunction(1 - y, 2), {0.3, 0.8}));
  EXPECT_FALSE(common_zero(line, LevelFunction(y - x - 1, 2), {0, 0}));
  EXPECT_FALSE(common_zero(circle, LevelFunction(y - 2, 2), {0.3, 0.8}));
}

TEST(NearestZero, FollowsTheGradient) {
  const auto point = nearest_zero(circle, {0.3, 0.4});
  ASSERT_TRUE(point);
  EXPECT_NEAR((*point)[0], 0.6, 2e-16);
  EXPECT_NEAR((*point)[1], 0.8, 2e-16);
}

TEST(NearestZero, WithoutAZeroIsEmpty) {
  EXPECT_FALSE(nearest_zero(LevelFunction(1 + x * x + y * y, 2), {0.3, 0.4}));
  EXPECT_FALSE(nearest_zero(circle, {0, 0}));  // no direction to go
}

TEST(DoubleZero, IsAnExtremeThatVanishes) {
  const Field u = x - 0.3, v = y + 0.2;
  for (const Field& f : {Field(-(u * u + 4 * v * v)), Field(1.0 - exp(u * u + v * v)),
                         Field(pow(u * u + v * v, 1.0) * (2.0 + sin(3 * x)))}) {
    const auto zero = double_zero(LevelFunction(f, 2), {0.301, -0.1985});
    ASSERT_TRUE(zero);
    // The value is of second order: rounding of 1 − exp leaves the root of it.
    EXPECT_NEAR((*zero)[0], 0.3, 1e-8);
    EXPECT_NEAR((*zero)[1], -0.2, 1e-8);
  }
  // A curve of them.
  const auto on_circle = double_zero(LevelFunction(pow(1.0 - x * x - y * y, 2.0), 2), {0.61, 0.79});
  ASSERT_TRUE(on_circle);
  EXPECT_NEAR(std::hypot((*on_circle)[0], (*on_circle)[1]), 1, 1e-12);
  // An extreme that does not vanish.
  EXPECT_FALSE(double_zero(LevelFunction(-(u * u + v * v) - 1e-3, 2), {0.301, -0.1985}));
}

}  // namespace
}  // namespace rfm
