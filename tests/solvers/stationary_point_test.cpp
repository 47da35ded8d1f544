#include "solvers/stationary_point.hpp"

#include <gmock/gmock.h>

#include <cmath>

#include "core/primitives.hpp"

namespace rfm {
namespace {

const Field x = x_coordinate(), y = y_coordinate(), z = z_coordinate();

void expect_at(const std::optional<Point>& found, const Point& expected) {
  ASSERT_TRUE(found.has_value());
  for (int axis = 0; axis < 3; ++axis) EXPECT_NEAR((*found)[axis], expected[axis], 1e-12);
}

TEST(StationaryPoints, AreFoundInsideOnFacesAlongEdgesAndAtCorners) {
  // f has its maximum at (1, 2, 3); on the unit sphere along that direction; on its equator along
  // (1, 2); and on equator and the plane x = 0.6 at y = 0.8.
  const Field f = -pow(x - 1, 2) - pow(y - 2, 2) - pow(z - 3, 2);
  const Field sphere = 1 - x * x - y * y - z * z;
  StationaryPoints points(f, {sphere, z, x - 0.6}, 3);
  const int active[] = {0, 1, 2};
  const double r = std::sqrt(14.0), s = std::sqrt(5.0);
  expect_at(points.find({}, {0.9, 2.2, 2.9}, 1), {1, 2, 3});
  expect_at(points.find(std::span(active, 1), {0.3, 0.5, 0.7}, 1), {1 / r, 2 / r, 3 / r});
  expect_at(points.find(std::span(active, 2), {0.5, 0.8, 0.1}, 1), {1 / s, 2 / s, 0});
  expect_at(points.find(active, {0.5, 0.7, 0.1}, 1), {0.6, 0.8, 0});
  EXPECT_NEAR(points.value({1, 2, 4}), -1, 1e-15);
  EXPECT_EQ(points.constraint(2, {1, 0, 0}), 0.4);
}

TEST(StationaryPoints, TakeTheShortestStepWhereAFunctionIsConstantAlongAFace) {
  // −x² on the plane z = 1 is stationary along the line x = 0: the nearest point of it is found.
  StationaryPoints points(-x * x, {z - 1}, 3);
  const int face[] = {0};
  expect_at(points.find(face, {0.2, 0.7, 0.9}, 1), {0, 0.7, 1});
}

TEST(StationaryPoints, NoneIsFoundBeyondReachOrWhereThereIsNone) {
  StationaryPoints points(-pow(x - 3, 2) - y * y, {y - 1}, 2);
  const int line[] = {0};
  EXPECT_FALSE(points.find(line, {0, 1}, 1));
  EXPECT_TRUE(points.find(line, {0, 1}, 4));
  StationaryPoints linear(x + y, {1 - x * x - y * y}, 2);
  EXPECT_TRUE(linear.find(line, {0.5, 0.8}, 1));
  EXPECT_FALSE(StationaryPoints(log(x), {}, 1).find({}, {0.5}, 1));
}

}  // namespace
}  // namespace rfm
