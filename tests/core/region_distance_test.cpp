// The distance of two regions (core/relations.hpp) against closed forms.

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "core/bounding_box.hpp"
#include "core/error.hpp"
#include "core/primitives.hpp"
#include "core/relations.hpp"

namespace rfm {
namespace {

RegionDistance distance(const Region& a, const Region& b, double tolerance,
                        int most_pairs = 400000) {
  const RegionEvaluator first(a), second(b);
  return distance_between(first, bounding_box(first), second, bounding_box(second), tolerance,
                          most_pairs);
}

// Bounds hold, are as near as asked for, and the points attain the upper one.
void expect_distance(const Region& a, const Region& b, double exact, double tolerance) {
  const RegionDistance found = distance(a, b, tolerance);
  EXPECT_LE(found.distance.low, exact * (1 + 1e-14));
  EXPECT_GE(found.distance.high, exact * (1 - 1e-14));
  EXPECT_LE(found.distance.width(), tolerance * (1 + 1e-9));
  const Point &p = found.first, &q = found.second;
  EXPECT_NEAR(std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]), found.distance.high, 1e-14);
  EXPECT_TRUE(RegionEvaluator(a).contains(p));
  EXPECT_TRUE(RegionEvaluator(b).contains(q));
}

TEST(RegionDistance, OfBallsIsThatOfTheirCentresLessTheirRadii) {
  std::mt19937 generator(5);
  const auto uniform = [&](double low, double high) {
    return low + (high - low) * 0x1p-32 * generator();
  };
  for (int i = 0; i < 6; ++i) {
    const Point p{uniform(-1, 1), uniform(-1, 1), uniform(-1, 1)};
    const Point q{uniform(2, 4), uniform(2, 4), uniform(2, 4)};
    const double r = uniform(0.2, 0.9), s = uniform(0.2, 0.9);
    expect_distance(circle(p, r), circle(q, s), std::hypot(p[0] - q[0], p[1] - q[1]) - r - s, 1e-7);
    expect_distance(sphere(p, r), sphere(q, s),
                    std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]) - r - s, 1e-2);
  }
}

TEST(RegionDistance, OfShapesThatAreNotConvexIsTheNearest) {
  const Region ring = circle({0, 0}, 2) - circle({0, 0}, 1);
  expect_distance(ring, circle({0.2, 0}, 0.3), 0.5, 1e-2);  // within the hole
  expect_distance(ring, circle({0.2, 0.1}, 0.9), 0, 1e-2);
  const Region ell = box({0, 0}, {2, 2}) - box({1, 1}, {3, 3});
  expect_distance(ell, box({1.5, 1.25}, {1.75, 1.75}), 0.25, 1e-2);
  // A ball on the axis of a torus.
  expect_distance(torus({0, 0, 0}, {0, 0, 1}, 2, 0.5), sphere({0, 0, 1.5}, 0.25), 2.5 - 0.75, 1e-2);
}

TEST(RegionDistance, HoldsWithAnyBudget) {
  for (const int pairs : {1, 10, 100, 1000}) {
    const RegionDistance found = distance(circle({0, 0}, 1), circle({3, 4}, 0.5), 1e-12, pairs);
    EXPECT_LE(found.distance.low, 3.5);
    EXPECT_GE(found.distance.high, 3.5);
    EXPECT_LE(found.pairs, pairs + 4);
  }
}

TEST(RegionDistance, OfNothingOrOfOtherDimensionsDoesNotExist) {
  const RegionEvaluator disk(circle({0, 0}, 1)), ball(sphere({0, 0, 0}, 1)),
      nothing(circle({0, 0}, 1) & circle({5, 0}, 1));
  const Box plane{2, {-1, -1}, {1, 1}}, space{3, {-1, -1, -1}, {1, 1, 1}};
  EXPECT_THROW(distance_between(disk, plane, ball, space, 1e-3), InvalidArgument);
  EXPECT_THROW(distance_between(disk, plane, nothing, plane, 1e-3), InvalidArgument);
}

}  // namespace
}  // namespace rfm
