#include "core/regularity.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <numbers>

#include "core/bounding_box.hpp"
#include "core/evaluate.hpp"
#include "core/primitives.hpp"
#include "core/r_functions.hpp"

namespace rfm {
namespace {

using Kind = Irregularity::Kind;
using testing::HasSubstr;

std::vector<Irregularity> found_in(const Region& region) {
  const RegionEvaluator evaluator(region);
  return irregularities(evaluator, bounding_box(evaluator));
}

void expect_regular(const Region& region) { EXPECT_TRUE(found_in(region).empty()); }

// Unit disks about three points at distance 1 from the origin: their circles meet there.
Region three_disks() {
  const auto disk = [](int k) {
    const double t = 0.4 + 2 * std::numbers::pi * k / 3;
    return circle({std::cos(t), std::sin(t)}, 1).named("d" + std::to_string(k));
  };
  return disk(0) | disk(1) | disk(2);
}

TEST(Irregularities, OfTwoRectanglesAreAllOfTheSideTheyShare) {
  const Region two = box({0, 0}, {1, 2}).named("a") | box({1, 0.5}, {3, 1.25}).named("b");
  const auto list = found_in(two);
  ASSERT_EQ(list.size(), 1u);
  EXPECT_EQ(list[0].kind, Kind::interior_zero);
  EXPECT_NEAR(list[0].place[0], 1, 1e-12);
  EXPECT_EQ(list[0].primitives.size(), 2u);
  EXPECT_NEAR(list[0].extent.low[0], 1, 1e-12);
  EXPECT_NEAR(list[0].extent.high[0], 1, 1e-12);
  EXPECT_NEAR(list[0].extent.low[1], 0.5, 5e-3);
  EXPECT_NEAR(list[0].extent.high[1], 1.25, 5e-3);
  EXPECT_NEAR(value_at(implicit(two), list[0].place), 0, 1e-12);
  const std::string text = describe(list[0], RegionEvaluator(two));
  EXPECT_THAT(text, HasSubstr("where a.right and b.left vanish together"));
  EXPECT_THAT(text, HasSubstr("join a shape that covers"));
}

TEST(Irregularities, AreCoveredByAFurtherShape) {
  const Region two = box({0, 0}, {1, 1}).named("a") | box({1, 0}, {2, 1}).named("b");
  EXPECT_EQ(found_in(two).size(), 1u);
  const Region covered = two | box({0.5, 0}, {1.5, 1}).named("cover");
  // The long sides coincide with others, which bound the region as before.
  expect_regular(covered);
  EXPECT_GT(value_at(implicit(covered), {1, 0.5}), 0.1);
}

TEST(Irregularities, OfThreeDisksIsThePointWhereTheirCirclesMeet) {
  const auto list = found_in(three_disks());
  ASSERT_EQ(list.size(), 1u);
  EXPECT_EQ(list[0].kind, Kind::interior_zero);
  EXPECT_EQ(list[0].primitives, (std::vector<int>{0, 1, 2}));
  EXPECT_NEAR(std::hypot(list[0].place[0], list[0].place[1]), 0, 1e-9);
  EXPECT_LT(list[0].extent.longest_side(), 1e-9);
  EXPECT_THAT(describe(list[0], RegionEvaluator(three_disks())),
              HasSubstr("where d0, d1 and d2 vanish together"));
  expect_regular(three_disks() | circle({0, 0}, 0.3).named("cover"));
}

TEST(Irregularities, AreRemovedByASignedFunctionOfAnIndependentComplement) {
  // Outside of three disks and, to separate the origin from it, of the triangle whose corners are
  // the outer crossings of the circles.
  const Region disks = three_disks();
  // Each two circles cross again opposite to the third centre, at distance 1: the chord of disk k
  // is the line at distance ½ from the origin towards its centre.
  std::vector<Region> sides;
  for (int k = 0; k < 3; ++k) {
    const double t = 0.4 + 2 * std::numbers::pi * k / 3, c = std::cos(t), s = std::sin(t);
    sides.push_back(half_plane({0.5 * c, 0.5 * s}, {c, s}));
  }
  const Region outside = (!disks) & (sides[0] | sides[1] | sides[2]);
  const Field signed_one = signed_function(disks, outside);
  EXPECT_GT(value_at(signed_one, {0, 0}), 0.1);
  // The formal complement removes nothing.
  EXPECT_NEAR(value_at(signed_function(disks, !disks), {0, 0}), 0, 1e-15);
  const RegionEvaluator evaluator(disks);
  for (double x = -2.1; x < 2.2; x += 0.0611)
    for (double y = -2.1; y < 2.2; y += 0.0617)
      EXPECT_EQ(value_at(signed_one, {x, y}) > 0, evaluator.contains(Point{x, y}))
          << x << ", " << y;
  // Zero on the boundary, and normalised there.
  const double t = 0.4;
  const Point at{2 * std::cos(t), 2 * std::sin(t)};
  const PointJet jet = evaluate(signed_one, at, 1, 2);
  EXPECT_NEAR(jet.value(), 0, 1e-14);
  EXPECT_NEAR(std::hypot(jet.derivative(1, 0), jet.derivative(0, 1)), 1, 1e-12);
}

TEST(Irregularities, OfZeroAndZeroDangle) {
  // {x ≥ 0} ∩ {x ≤ 0} within a disk: a segment without interior.
  const Region disk = circle({3, 0}, 1).named("disk");
  const Region line = half_plane({0, 0}, {1, 0}).named("p") &
                      half_plane({0, 0}, {-1, 0}).named("n") & circle({0, 0}, 0.5).named("c");
  const RegionEvaluator both(disk | line);
  const auto list = irregularities(both, Box{2, {-1, -1}, {4, 1}});
  ASSERT_EQ(list.size(), 1u);
  EXPECT_EQ(list[0].kind, Kind::dangling);
  EXPECT_NEAR(list[0].place[0], 0, 1e-12);
  EXPECT_NEAR(list[0].extent.length(1), 1, 1e-2);
  EXPECT_THAT(describe(list[0], both), HasSubstr("where p and n vanish together"));
  EXPECT_THAT(describe(list[0], both), HasSubstr("dangling piece"));
}

TEST(Irregularities, OfTheFlagIsItsHandle) {
  // V. Shapiro, Acta Numerica 16 (2007), eq. (4.7).
  const Field x = x_coordinate(), y = y_coordinate();
  const Region flag = level_set((25 - (x - 3) * (x - 3) - (y - 4) * (y - 4)) * 0.1).named("fly") &
                      level_set(5 + 0.25 * sin(2 * x) - y).named("top") &
                      level_set(x - 2).named("pole") & level_set(y - 3).named("bottom");
  expect_regular(flag);
  const Region handle = level_set(-abs(x - 2)).named("line") & circle({2, 2}, 1).named("reach");
  const auto list = found_in(flag | handle);
  ASSERT_EQ(list.size(), 1u);
  EXPECT_EQ(list[0].kind, Kind::dangling);
  EXPECT_NEAR(list[0].place[0], 2, 1e-9);
  EXPECT_NEAR(list[0].extent.low[1], 1, 0.02);
  EXPECT_NEAR(list[0].extent.high[1], 3, 0.02);
}

TEST(Irregularities, AreNotSeenWhereThereAreNone) {
  expect_regular(box({0, 0}, {1, 1}).named("big") - box({0.5, 0.5}, {2, 2}).named("small"));
  expect_regular(circle({0, 0}, 1).named("a") | circle({1, 0}, 1).named("b"));
  expect_regular(circle({0, 0}, 1).named("a") ^ circle({1, 0}, 1).named("b"));
  expect_regular(circle({0, 0}, 1).named("a") | circle({2, 0}, 1).named("b"));      // touch outside
  expect_regular(box({0, 0}, {1, 1}).named("a") | box({1, 1}, {2, 2}).named("b"));  // at a corner
  expect_regular(box({0, 0, 0}, {1, 1, 1}, 3).named("b") -
                 cylinder({0.5, 0.5, 0.5}, {0, 0, 1}, 0.2, 3).named("c"));
  expect_regular(cone({0, 0, 0}, {0, 0, 1}, 0.5, 2).named("cone"));
}

TEST(Irregularities, InSpaceAreFacesEdgesAndPoints) {
  // Two bricks share a part of a face.
  const auto face = found_in(box({0, 0, 0}, {1, 1, 1}, 3).named("a") |
                             box({1, 0.25, 0}, {2, 0.75, 2}, 3).named("b"));
  ASSERT_EQ(face.size(), 1u);
  EXPECT_EQ(face[0].kind, Kind::interior_zero);
  EXPECT_NEAR(face[0].place[0], 1, 1e-12);
  EXPECT_NEAR(face[0].extent.length(1), 0.5, 0.15);
  EXPECT_NEAR(face[0].extent.length(2), 1, 0.15);
  // Three cylinders along z whose circles meet on the axis: an edge inside.
  Region rods = cylinder({1, 0, 0}, {0, 0, 1}, 1).named("r0");
  for (int k = 1; k < 3; ++k) {
    const double t = 2 * std::numbers::pi * k / 3;
    rods =
        rods | cylinder({std::cos(t), std::sin(t), 0}, {0, 0, 1}, 1).named("r" + std::to_string(k));
  }
  const auto edge = found_in(rods & half_space({0, 0, -1}, {0, 0, 1}).named("low") &
                             half_space({0, 0, 1}, {0, 0, -1}).named("high"));
  ASSERT_EQ(edge.size(), 1u);
  EXPECT_EQ(edge[0].primitives, (std::vector<int>{0, 1, 2}));
  EXPECT_NEAR(std::hypot(edge[0].place[0], edge[0].place[1]), 0, 1e-9);
  EXPECT_NEAR(edge[0].extent.length(2), 2, 0.2);
}

TEST(Irregularities, OfIsolatedPointsAreFound) {
  const Field x = x_coordinate(), y = y_coordinate();
  const Region disk = circle({3, 0.25}, 1).named("disk");
  // −|p|² is in the region at its zero alone; |p|² takes its zero out of ω, and not of the region.
  const Region point = level_set(-(x * x + y * y)).named("point");
  auto list = found_in(disk | point);
  ASSERT_EQ(list.size(), 1u);
  EXPECT_EQ(list[0].kind, Kind::dangling);
  EXPECT_EQ(list[0].place, (Point{0, 0}));
  EXPECT_THAT(describe(list[0], RegionEvaluator(disk | point)),
              HasSubstr("a dangling piece at (0, 0), where point vanishes"));
  const Field u = x - 2.7, v = y - 0.1;
  const Region pierced = disk & level_set(u * u + 3 * v * v).named("hole");
  list = found_in(pierced);
  ASSERT_EQ(list.size(), 1u);
  EXPECT_EQ(list[0].kind, Kind::interior_zero);
  EXPECT_NEAR(list[0].place[0], 2.7, 1e-12);
  EXPECT_NEAR(list[0].place[1], 0.1, 1e-12);
  EXPECT_THAT(describe(list[0], RegionEvaluator(pierced), false), HasSubstr("structure is not"));
}

TEST(Irregularities, OfASingleShapeThatChangesItsSignElsewhereAreFound) {
  const Field x = x_coordinate(), y = y_coordinate(), disk = 1 - x * x - y * y;
  auto list = found_in(level_set((pow(x - 0.2, 2.0) + pow(y - 0.1, 2.0)) * disk)
                           .named("a")
                           .within({2, {-1, -1, 0}, {1, 1, 0}}));
  ASSERT_EQ(list.size(), 1u);
  EXPECT_EQ(list[0].kind, Kind::interior_zero);
  EXPECT_NEAR(list[0].place[0], 0.2, 1e-12);
  EXPECT_NEAR(list[0].place[1], 0.1, 1e-12);
  list = found_in(level_set(abs(x - y) * disk).named("a").within({2, {-1, -1, 0}, {1, 1, 0}}));
  ASSERT_FALSE(list.empty());
  EXPECT_EQ(list[0].kind, Kind::interior_zero);
  EXPECT_GT(list[0].extent.length(0), 1.3);
  // Regular ones are not: corners and kinks of one function on its boundary.
  EXPECT_TRUE(found_in(level_set(min(disk, x + 0.3)).named("a").within({2, {-1, -1, 0}, {1, 1, 0}}))
                  .empty());
}

TEST(Irregularities, OfTinyShapesAreThoseOfLargeOnes) {
  for (const double size : {1e-9, 1.0, 1e9}) {
    const Region two = box({0, 0}, {size, 2 * size}).named("a") |
                       box({size, 0.5 * size}, {3 * size, 1.25 * size}).named("b");
    const auto list = found_in(two);
    ASSERT_EQ(list.size(), 1u) << size;
    EXPECT_NEAR(list[0].extent.high[1], 1.25 * size, 5e-3 * size);
    EXPECT_THAT(describe(list[0], RegionEvaluator(two)), HasSubstr("between ("));
  }
}

TEST(FormalComplements, AreThoseOfTheSamePrimitives) {
  const Region a = box({0, 0}, {1, 1}).named("a"), b = box({1, 0}, {2, 1}).named("b");
  EXPECT_TRUE(are_formal_complements(a | b, !(a | b)));
  EXPECT_TRUE(are_formal_complements(a - b, (!a) | b));
  EXPECT_FALSE(are_formal_complements(a | b, (!a) | (!b)));
  // The same set by another shape is an independent expression.
  EXPECT_FALSE(are_formal_complements(a | b, !box({0, 0}, {2, 1}).named("e")));
}

}  // namespace
}  // namespace rfm
