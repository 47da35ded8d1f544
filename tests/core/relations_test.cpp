#include "core/relations.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "core/bounding_box.hpp"
#include "core/error.hpp"
#include "core/primitives.hpp"

namespace rfm {
namespace {

Box around(double half, int dimension) {
  return {dimension, {-half, -half, -half}, {half, half, half}};
}

TEST(Relations, MembershipIsUnknownOnTheBoundaryAlone) {
  const RegionEvaluator ring(circle({0, 0}, 1) - circle({0, 0}, 0.5));
  EXPECT_EQ(membership(ring, {0.7, 0}), Truth::yes);
  EXPECT_EQ(membership(ring, {0.3, 0}), Truth::no);
  EXPECT_EQ(membership(ring, {1.1, 0}), Truth::no);
  for (double t = 0; t < 6; t += 0.1) {
    EXPECT_EQ(membership(ring, {std::cos(t), std::sin(t)}), Truth::unknown);
    EXPECT_EQ(membership(ring, {0.5 * std::cos(t), 0.5 * std::sin(t)}), Truth::unknown);
  }
  EXPECT_EQ(membership(ring, {1 + 1e-3, 0}, 2e-3), Truth::unknown);
  EXPECT_EQ(membership(ring, {1 + 3e-3, 0}, 2e-3), Truth::no);
}

// Two balls meet if their centres are nearer than the sum of their radii.
TEST(Relations, BallsMeetAsTheirCentresSay) {
  std::mt19937 generator(3);
  const auto uniform = [&](double low, double high) {
    return low + (high - low) * 0x1p-32 * generator();
  };
  int meeting = 0, apart = 0;
  for (int i = 0; i < 60; ++i) {
    const int dimension = 2 + i % 2;
    const double r = uniform(0.2, 0.8), s = uniform(0.2, 0.8), gap = i % 3 == 0 ? 1e-3 : 0.3;
    const double d = r + s + (i % 4 < 2 ? gap : -gap), turn = uniform(0, 6), rise = uniform(-1, 1);
    const double flat = dimension == 3 ? std::sqrt(1 - rise * rise) : 1;
    const Point p{uniform(-1, 1), uniform(-1, 1), 0};
    const Point q{p[0] + d * flat * std::cos(turn), p[1] + d * flat * std::sin(turn),
                  dimension == 3 ? d * rise : 0};
    const auto ball = [&](const Point& center, double radius) {
      return dimension == 2 ? circle(center, radius) : sphere(center, radius);
    };
    const Relation relation = intersects(ball(p, r), ball(q, s), around(4, dimension));
    const auto distance = [](const Point& a, const Point& b) {
      return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
    };
    if (d > r + s) {
      EXPECT_EQ(relation.answer, Truth::no);
      ++apart;
    } else {
      ASSERT_EQ(relation.answer, Truth::yes);
      EXPECT_LE(distance(*relation.witness, p), r);
      EXPECT_LE(distance(*relation.witness, q), s);
      ++meeting;
    }
    EXPECT_LT(relation.boxes, 2000);
  }
  EXPECT_GT(meeting, 20);
  EXPECT_GT(apart, 20);
}

TEST(Relations, TouchingFromOutsideIsLeftOpen) {
  const Relation relation =
      intersects(circle({-0.7, 0.1}, 0.7), circle({0.5, 0.1}, 0.5), around(2, 2));
  EXPECT_NE(relation.answer, Truth::no);
  if (relation.answer == Truth::unknown) {
    ASSERT_TRUE(relation.undecided);
    EXPECT_NEAR(relation.undecided->center()[0], 0, 1e-3);
    EXPECT_NEAR(relation.undecided->center()[1], 0.1, 1e-3);
  }
}

TEST(Relations, InclusionHasProofOrAWitness) {
  const Region plate = box({0, 0}, {2, 1}), hole = circle({0.7, 0.5}, 0.25);
  EXPECT_EQ(lies_in(hole, plate, around(3, 2)).answer, Truth::yes);
  EXPECT_EQ(lies_in(plate & hole, plate, around(3, 2)).answer, Truth::yes);
  const Relation out = lies_in(circle({0.7, 0.5}, 0.51), plate, around(3, 2));
  ASSERT_EQ(out.answer, Truth::no);
  EXPECT_GT(std::fabs((*out.witness)[1] - 0.5), 0.5);
  EXPECT_EQ(lies_in(plate, plate - hole, around(3, 2)).answer, Truth::no);
}

TEST(Relations, InclusionIsProvedWhereBoundariesAreTheSame) {
  const Region disk = circle({0, 0}, 1), half = half_plane({0, 0}, {1, 0}),
               plate = box({0, 0}, {1, 1});
  const Box bounds = around(1.5, 2);
  EXPECT_EQ(lies_in(disk, disk, bounds).answer, Truth::yes);
  EXPECT_EQ(lies_in(plate, plate, bounds).answer, Truth::yes);
  EXPECT_EQ(lies_in(disk & half, disk, bounds).answer, Truth::yes);
  EXPECT_EQ(lies_in(disk & half, half, bounds).answer, Truth::yes);
  EXPECT_EQ(lies_in(disk - half, disk - half, bounds).answer, Truth::yes);
  EXPECT_EQ(lies_in(disk, disk | plate, bounds).answer, Truth::yes);
  // Two circles that happen to be equal are not known to be so.
  RelationOptions coarse;
  coarse.resolution = 1e-3;
  EXPECT_EQ(lies_in(disk, circle({0, 0}, 1), bounds, coarse).answer, Truth::unknown);
  const Region ball = sphere({0, 0, 0}, 1);
  EXPECT_EQ(lies_in(ball, ball | box({0, 0, 0}, {1, 1, 1}, 3), around(1.5, 3)).answer, Truth::yes);
  // Not the other way round, and not where the same line bounds from the other side.
  EXPECT_EQ(lies_in(disk, disk & half, bounds).answer, Truth::no);
  EXPECT_EQ(lies_in(disk & half, disk - half, bounds).answer, Truth::no);
  // The disk and its complement share the circle, which the half plane does not hold.
  EXPECT_NE(lies_in(disk & !disk, half, bounds).answer, Truth::yes);
  EXPECT_EQ(lies_in(disk & !disk, disk, bounds).answer, Truth::yes);
}

TEST(Relations, MembershipMeasuresDistancesWhateverTheSlope) {
  // The level function 1 − x²/4 − y² has slope 2 at (0, 1).
  const RegionEvaluator region(ellipse({0, 0}, {2, 1}));
  EXPECT_EQ(membership(region, {0, 1 + 1.5e-3}, 2e-3), Truth::unknown);
  EXPECT_EQ(membership(region, {0, 1 + 2.5e-3}, 2e-3), Truth::no);
  EXPECT_EQ(membership(region, {0, 1 - 2.5e-3}, 2e-3), Truth::yes);
}

TEST(Relations, OnlyPointsWithinTheBoundsCount) {
  // The disk ends at 0.7071 along the diagonal; its points nearest to these bounds lie outside.
  const Region disk = circle({0, 0}, 1);
  EXPECT_EQ(intersects(disk, disk, Box{2, {0.72, 0.72}, {2, 2}}).answer, Truth::no);
  const Box wider{2, {0.7, 0.7}, {2, 2}};
  const Relation corner = intersects(disk, disk, wider);
  ASSERT_EQ(corner.answer, Truth::yes);
  EXPECT_TRUE(wider.contains(*corner.witness));
}

TEST(Relations, WhatPokesOutByLessThanTheResolutionIsLeftOpen) {
  RelationOptions coarse;
  coarse.resolution = 1e-2;
  const Region outer = circle({0, 0}, 1);
  const Relation relation =
      lies_in(circle({0.3, 0.1}, 1 - std::hypot(0.3, 0.1) + 1e-9), outer, around(2, 2), coarse);
  EXPECT_NE(relation.answer, Truth::yes);
  EXPECT_EQ(relation.undecided.has_value(), relation.answer == Truth::unknown);
}

TEST(Relations, TheNumberOfBoxesIsBounded) {
  RelationOptions few;
  few.resolution = 1e-15;
  few.most_boxes = 50;
  // Two functions of one set: no bound tells that none is larger, and no point is outside.
  const Relation relation = lies_in(circle({0, 0}, 1), ellipse({0, 0}, {1, 1}), around(2, 2), few);
  EXPECT_LE(relation.boxes, 50);
  EXPECT_EQ(relation.answer, Truth::unknown);
  EXPECT_TRUE(relation.undecided);
}

TEST(Relations, AnAnswerOfYesLeavesNothingUndecided) {
  // Two disks 1e-12 apart, of which a coarse resolution knows nothing, before a third one: boxes
  // are cut off to less than 0.6 of the bounds before the half with the third is looked at.
  RelationOptions coarse;
  coarse.resolution = 0.6;
  const Region near = circle({-0.71, 0.013}, 0.2) & circle({-0.31 + 1e-12, 0.013}, 0.2);
  EXPECT_EQ(has_points(RegionEvaluator(near), around(1, 2), coarse).answer, Truth::unknown);
  const Relation relation =
      has_points(RegionEvaluator(near | circle({0.6, 0.3}, 0.2)), around(1, 2), coarse);
  EXPECT_EQ(relation.answer, Truth::yes);
  EXPECT_FALSE(relation.undecided);
}

TEST(Relations, DistancesOfConvexBodiesAreTheirClosedForms) {
  const auto distance = [](const Region& a, const Region& b, double tolerance) {
    const RegionEvaluator first(a), second(b);
    return distance_between(first, bounding_box(first), second, bounding_box(second), tolerance);
  };
  const double tolerance = 1e-4;
  const auto expect = [&](const RegionDistance& found, double exact) {
    EXPECT_LE(found.distance.low, exact + 1e-12);
    EXPECT_GE(found.distance.high, exact - 1e-12);
    EXPECT_LE(found.distance.width(), tolerance + 1e-12);
    EXPECT_NEAR(std::hypot(found.first[0] - found.second[0], found.first[1] - found.second[1],
                           found.first[2] - found.second[2]),
                found.distance.high, 1e-12);
  };
  expect(distance(circle({0, 0}, 1), circle({3, 4}, 0.5), tolerance), 3.5);
  expect(distance(box({0, 0}, {1, 1}), box({2, 3}, {4, 4}), tolerance), std::sqrt(5));
  expect(distance(box({0, 0}, {1, 1}), circle({2, 0.5}, 0.25), tolerance), 0.75);
  // The point of the ellipse nearest to (0, 5) is (0, 1).
  expect(distance(ellipse({0, 0}, {2, 1}), circle({0, 5}, 1), tolerance), 3);
  expect(distance(circle({0, 0}, 1), circle({0.5, 0}, 1), tolerance), 0);
}

TEST(Relations, RegionsOfOneDimensionOnlyAreCompared) {
  EXPECT_THROW(intersects(circle({0, 0}, 1), sphere({0, 0, 0}, 1), around(2, 2)), InvalidArgument);
  EXPECT_THROW(lies_in(circle({0, 0}, 1), sphere({0, 0, 0}, 1), around(2, 2)), InvalidArgument);
}

}  // namespace
}  // namespace rfm
