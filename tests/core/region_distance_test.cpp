// The distance of two regions (core/relations.hpp) against closed forms.

#include <gtest/gtest.h>

#include <algorithm>
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

// Bounds hold, are as near as asked for after so many pairs of boxes, and the points attain the
// upper one.
void expect_distance(const Region& a, const Region& b, double exact, double tolerance,
                     int most_pairs) {
  const RegionDistance found = distance(a, b, tolerance);
  EXPECT_LE(found.distance.low, exact + 1e-14);
  EXPECT_NEAR(found.distance.high, exact, 1e-10);
  EXPECT_GE(found.distance.high, exact - 1e-14);
  EXPECT_LE(found.distance.width(), tolerance * (1 + 1e-9));
  EXPECT_LE(found.pairs, most_pairs);
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
  for (int i = 0; i < 20; ++i) {
    const Point p{uniform(-1, 1), uniform(-1, 1), uniform(-1, 1)};
    const Point q{uniform(2, 4), uniform(2, 4), uniform(2, 4)};
    const double r = uniform(0.2, 0.9), s = uniform(0.2, 0.9);
    expect_distance(circle(p, r), circle(q, s), std::hypot(p[0] - q[0], p[1] - q[1]) - r - s, 1e-12,
                    200);
    expect_distance(sphere(p, r), sphere(q, s),
                    std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]) - r - s, 1e-12, 200);
  }
}

TEST(RegionDistance, OfABoxAndABallIsThatOfTheCornerTheEdgeOrTheFace) {
  const Region block = box({0, 0, 0}, {1, 1, 1}, 3);
  expect_distance(block, sphere({2, 3, 3}, 0.5), 2.5, 1e-12, 100);
  expect_distance(block, sphere({4, 5, 0.3}, 0.5), 4.5, 1e-12, 100);
  expect_distance(block, sphere({0.4, 0.3, 2.5}, 0.5), 1, 1e-12, 100);
  // Turned by 45° about z, an edge points along x.
  const Region turned = half_space({2, 0, 0}, {-1, -1, 0}) & half_space({2, 0, 0}, {-1, 1, 0}) &
                        half_space({0, 0, 0}, {1, 1, 0}) & half_space({0, 0, 0}, {1, -1, 0}) &
                        half_space({0, 0, 0}, {0, 0, 1}) & half_space({0, 0, 1}, {0, 0, -1});
  expect_distance(turned, sphere({4, 0, 0.5}, 1), 1, 1e-12, 200);
}

TEST(RegionDistance, WithinAHoleIsThatOfTheNearestPlaceOfTheRim) {
  const Region ring = circle({0, 0}, 2) - circle({0, 0}, 1);
  expect_distance(ring, circle({0.2, 0}, 0.3), 0.5, 1e-9, 2000);
  expect_distance(ring, circle({0.2, 0.1}, 0.9), 0, 1e-9, 1000);  // they overlap
}

// Nearest along a whole circle, on a sphere, between cylinders: Lagrange's function is as flat as
// the distance there, and quadratic, so that no boxes have to follow.
TEST(RegionDistance, AlongCurvesOfNearestPointsIsProvedOfQuadricsAtOnce) {
  expect_distance(circle({0, 0}, 2) - circle({0, 0}, 1), circle({0, 0}, 0.3), 0.7, 1e-10, 500);
  expect_distance(sphere({0, 0, 0}, 2) - sphere({0, 0, 0}, 1), sphere({0, 0, 0}, 0.3), 0.7, 1e-10,
                  2000);
  const Region tube = cylinder({0, 0, 0}, {0, 0, 1}, 2, 1) - cylinder({0, 0, 0}, {0, 0, 1}, 1, 3);
  expect_distance(tube, cylinder({0, 0, 0}, {0, 0, 1}, 0.3, 1), 0.7, 1e-10, 5000);
}

TEST(RegionDistance, OfAnLIsThatOfItsFacesAndOfItsTips) {
  const Region ell = box({0, 0}, {2, 2}) - box({1, 1}, {3, 3});
  expect_distance(ell, box({1.5, 1.25}, {1.75, 1.75}), 0.25, 1e-9, 200);
  expect_distance(ell, circle({1.6, 1.5}, 0.25), 0.25, 1e-9, 200);
  expect_distance(ell, circle({3, 3}, 0.25), std::sqrt(5.0) - 0.25, 1e-9, 200);
  // Into the corner that points inwards: its sides are equally near.
  expect_distance(ell, circle({1.4, 1.4}, 0.25), 0.15, 1e-9, 200);
  const Region bracket = box({0, 0, 0}, {2, 2, 1}, 3) - box({1, 1, -1}, {3, 3, 2}, 3);
  expect_distance(bracket, sphere({1.6, 1.4, 0.5}, 0.3), 0.1, 1e-9, 1000);
}

TEST(RegionDistance, OfATorusIsThatOfItsMiddleCircle) {
  const Region ring = torus({0, 0, 0}, {0, 0, 1}, 2, 0.5);
  const auto exact = [](const Point& c, double r) {
    return std::hypot(std::hypot(c[0], c[1]) - 2, c[2]) - 0.5 - r;
  };
  for (const Point& center : {Point{0.5, 0.2, 0}, Point{3, 2, 1}, Point{0.7, -0.4, 0.9}})
    expect_distance(ring, sphere(center, 0.25), exact(center, 0.25), 1e-6, 2000);
}

TEST(RegionDistance, OfATorusAndABallOnItsAxisIsTheSameAlongACircle) {
  const Region ring = torus({0, 0, 0}, {0, 0, 1}, 2, 0.5);
  expect_distance(ring, sphere({0, 0, 1.5}, 0.25), 1.75, 2e-2, 20000);
}

TEST(RegionDistance, OfLinkedRingsIsWhereTheyPassEachOther) {
  // Two rings of a chain, whose middle circles pass at distance 1.
  expect_distance(torus({0, 0, 0}, {0, 0, 1}, 1.5, 0.3), torus({2, 0, 0}, {0, 1, 0}, 1.5, 0.3), 0.4,
                  1e-6, 20000);
}

TEST(RegionDistance, HoldsWithAnyBudget) {
  const Region ring = circle({0, 0}, 2) - circle({0, 0}, 1), pin = circle({0, 0}, 0.3);
  for (const int pairs : {1, 10, 100, 1000}) {
    const RegionDistance found = distance(ring, pin, 1e-12, pairs);
    EXPECT_LE(found.distance.low, 0.7);
    EXPECT_GE(found.distance.high, 0.7 - 1e-15);
    EXPECT_LE(found.pairs, std::max(pairs, 40) + 4);  // some show no point of the ring
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
