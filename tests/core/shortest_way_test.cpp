#include "core/shortest_way.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "core/primitives.hpp"

namespace rfm {
namespace {

struct Found {
  Point first, second;
  double at_least;
};

Found found(const Region& a, const Box& box_a, const Region& b, const Box& box_b) {
  const RegionEvaluator first(a), second(b);
  SecondDerivatives of_first(first), of_second(second);
  const RegionPart part_a{&first, &of_first, box_a, necessary_signs(first, box_a)};
  const RegionPart part_b{&second, &of_second, box_b, necessary_signs(second, box_b)};
  const ShortestWay way(part_a, part_b);
  return {way.end(0), way.end(1), way.at_least()};
}

Box cube(const Point& center, double half, int dimension) {
  Box box{dimension, center, center};
  for (int axis = 0; axis < dimension; ++axis) {
    box.low[axis] -= half;
    box.high[axis] += half;
  }
  return box;
}

void expect_proved(const Found& way, double exact) {
  EXPECT_LE(way.at_least, exact);
  EXPECT_NEAR(way.at_least, exact, 1e-12);
  EXPECT_NEAR(std::hypot(way.first[0] - way.second[0], way.first[1] - way.second[1],
                         way.first[2] - way.second[2]),
              exact, 1e-12);
}

TEST(ShortestWay, OfConvexBodiesIsProvedOnBoxesAsLargeAsHalfOfThem) {
  const double apart = std::sqrt(14.0);
  expect_proved(found(sphere({0, 0, 0}, 1), cube({0, 0, 0.6}, 0.7, 3), sphere({1, 2, 3}, 0.5),
                      cube({1, 2, 2.7}, 0.3, 3)),
                apart - 1.5);
  // A corner, where three conditions bind, and an edge.
  const Region block = box({0, 0, 0}, {1, 1, 1}, 3);
  expect_proved(
      found(block, cube({0.5, 0.5, 0.5}, 0.6, 3), sphere({2, 3, 4}, 0.5), cube({2, 3, 4}, 0.6, 3)),
      apart - 0.5);
  expect_proved(found(block, cube({0.5, 0.5, 0.5}, 0.6, 3), sphere({4, 5, 0.3}, 0.5),
                      cube({4, 5, 0.3}, 0.6, 3)),
                4.5);
}

TEST(ShortestWay, FromAHollowIsProved) {
  // Within a hole: the way from the rim is a minimum although the rim bends towards it.
  const Region plate = box({-3, -3}, {3, 3}) - circle({0, 0}, 1);
  const Point rim{0.6, 0.8}, pin{0.45, 0.6};
  const Region disk = circle({0.3, 0.4}, 0.25);
  for (const double half : {0.05, 0.2})
    expect_proved(found(plate, cube(rim, half, 2), disk, cube(pin, half, 2)), 0.25);
}

TEST(ShortestWay, AlongACurveOfNearestPointsOfQuadricsIsProved) {
  const Region plate = box({-3, -3}, {3, 3}) - circle({0, 0}, 1), pin = circle({0, 0}, 0.5);
  for (const double half : {0.04, 0.02, 0.01})
    expect_proved(found(plate, cube({0.6, 0.8}, half, 2), pin, cube({0.3, 0.4}, half, 2)), 0.5);
}

TEST(ShortestWay, AlongACurveOfNearestPointsOfATorusIsBoundedToThirdOrder) {
  const Region ring = torus({0, 0, 0}, {0, 0, 1}, 2, 0.5), ball = sphere({0, 0, 0}, 0.5);
  double before = 0;
  for (const double half : {0.04, 0.02, 0.01}) {
    const Found way = found(ring, cube({0.9, 1.2, 0}, half, 3), ball, cube({0.3, 0.4, 0}, half, 3));
    const double defect = 1 - way.at_least;
    EXPECT_GT(defect, 0);
    if (before > 0) {
      EXPECT_GT(before / defect, 6);
      EXPECT_LT(before / defect, 10);
    }
    before = defect;
  }
  EXPECT_LT(before, 1e-4);
}

// Pairs of points of a torus and of a ball within random boxes: none is nearer than the bound.
TEST(ShortestWay, BoundsHoldOnEveryBox) {
  const Region ring = torus({0, 0, 0}, {0, 0, 1}, 2, 0.5);
  const Region ball = sphere({0.4, 0.3, 0.2}, 0.5);
  const RegionEvaluator first(ring), second(ball);
  std::mt19937 generator(11);
  const auto uniform = [&](double low, double high) {
    return low + (high - low) * 0x1p-32 * generator();
  };
  int useful = 0;
  for (int trial = 0; trial < 200; ++trial) {
    const double t = uniform(0, 6.3), s = uniform(0, 6.3);
    const double rho = 2 + 0.5 * std::cos(s);
    const Box a =
        cube({rho * std::cos(t), rho * std::sin(t), 0.5 * std::sin(s)}, uniform(0.02, 0.3), 3);
    const Box b =
        cube({0.4 + 0.5 * std::cos(t), 0.3 + 0.5 * std::sin(t), 0.2}, uniform(0.02, 0.3), 3);
    const double bound = found(ring, a, ball, b).at_least;
    useful += bound > 0;
    const auto point_in = [&](const Box& box) {
      return Point{uniform(box.low[0], box.high[0]), uniform(box.low[1], box.high[1]),
                   uniform(box.low[2], box.high[2])};
    };
    for (int sample = 0; sample < 400; ++sample) {
      const Point p = point_in(a), q = point_in(b);
      if (!first.contains(p) || !second.contains(q)) continue;
      ASSERT_GE(std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]), bound) << trial;
    }
  }
  EXPECT_GT(useful, 100);
}

}  // namespace
}  // namespace rfm
