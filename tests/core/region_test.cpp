#include "core/region.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <optional>

#include "core/error.hpp"
#include "core/evaluate.hpp"
#include "core/primitives.hpp"

namespace rfm {
namespace {

using testing::ElementsAre;

std::vector<std::string> names(const Region& region) {
  std::vector<std::string> list;
  for (const auto& primitive : region.primitives()) list.push_back(primitive->name);
  return list;
}

TEST(Region, PrimitivesAreNamedAfterTheShape) {
  EXPECT_THAT(names(circle({0, 0}, 1).named("hole")), ElementsAre("hole"));
  EXPECT_THAT(names(box({0, 0}, {1, 1}).named("plate")),
              ElementsAre("plate.left", "plate.right", "plate.bottom", "plate.top"));
  EXPECT_THAT(
      names(box({0, 0}, {1, 1}).named("plate").named("part")),
      ElementsAre("part.plate.left", "part.plate.right", "part.plate.bottom", "part.plate.top"));
}

TEST(Region, ASharedPrimitiveRemainsOne) {
  const Region plate = box({0, 0}, {2, 1}).named("plate"), hole = circle({1, 0.5}, 0.2).named("h");
  EXPECT_EQ(((plate - hole) | (plate & hole)).primitives().size(), 5u);
  EXPECT_EQ((hole & circle({1, 0.5}, 0.2).named("h")).primitives().size(), 2u);
}

TEST(Region, OperatorsAreThoseOfSets) {
  const Region a = circle({0, 0}, 1), b = circle({0.8, 0.1}, 0.7);
  const RegionEvaluator both(a & b), any(a | b), rest(a - b), one(a ^ b), outside(!a), first(a),
      second(b);
  for (double x = -1.33; x < 1.6; x += 0.107)
    for (double y = -1.21; y < 1.3; y += 0.093) {
      const Point at{x, y};
      const bool p = first.contains(at), q = second.contains(at);
      EXPECT_EQ(both.contains(at), p && q);
      EXPECT_EQ(any.contains(at), p || q);
      EXPECT_EQ(rest.contains(at), p && !q);
      EXPECT_EQ(one.contains(at), p != q);
      EXPECT_EQ(outside.contains(at), !p);
    }
}

TEST(Region, EnclosuresFollowTheOperatorsOfSets) {
  const auto known = [](double from, double to) {
    return box({from, from}, {to, to}).within({2, {from, from}, {to, to}});
  };
  const Region a = known(0, 2), b = known(1, 4), unknown = half_plane({0, 0}, {1, 0});
  const auto is = [](const Region& region, double from, double to) {
    const std::optional<Box>& box = region.enclosure();
    if (!box) return false;
    return box->low[0] == from && box->low[1] == from && box->high[0] == to && box->high[1] == to;
  };
  EXPECT_TRUE(is(a & b, 1, 2));
  EXPECT_TRUE(is(a | b, 0, 4));
  EXPECT_TRUE(is(a ^ b, 0, 4));
  EXPECT_TRUE(is(b - a, 1, 4));
  EXPECT_TRUE(is(a & unknown, 0, 2));
  EXPECT_TRUE(is(unknown & a, 0, 2));
  EXPECT_TRUE(is(a.named("plate"), 0, 2));
  EXPECT_FALSE((a | unknown).enclosure());
  EXPECT_FALSE((unknown - a).enclosure());
  EXPECT_FALSE((a ^ unknown).enclosure());
  EXPECT_FALSE((!a).enclosure());
  EXPECT_FALSE(a.with_expression(!a.expression()).enclosure());
}

TEST(Region, OnlyRegionsOfOneDimensionCombine) {
  EXPECT_THROW(box({0, 0}, {1, 1}) & box({0, 0, 0}, {1, 1, 1}, 3), InvalidArgument);
  EXPECT_THROW(Region({"w", x_coordinate(), x_coordinate()}, 4), InvalidArgument);
  EXPECT_THROW(Region({"w", x_coordinate(), x_coordinate()}, 0), InvalidArgument);
}

TEST(Region, MembershipOfABoxIsThatOfAllItsPoints) {
  const RegionEvaluator ring(circle({0, 0}, 1) - circle({0.2, 0}, 0.4));
  int decided = 0, all = 0;
  for (double x = -1.3; x < 1.3; x += 0.1)
    for (double y = -1.3; y < 1.3; y += 0.1, ++all) {
      const Box cell{2, {x, y}, {x + 0.1, y + 0.1}};
      const Truth truth = ring.contains(cell);
      if (truth == Truth::unknown) continue;
      ++decided;
      for (const double s : {0.0, 0.3, 1.0})
        for (const double t : {0.0, 0.6, 1.0})
          EXPECT_EQ(ring.contains(Point{x + 0.1 * s, y + 0.1 * t}), truth == Truth::yes);
    }
  // A circle crosses 8r/h lines of the grid, and a cell for each; few others may be undecided.
  EXPECT_LT(all - decided, 1.25 * 8 * (1 + 0.4) / 0.1);
}

TEST(Region, WithAToleranceBothSidesOfEveryFaceAreClosed) {
  const RegionEvaluator ring(circle({0, 0}, 1) - circle({0, 0}, 0.5));
  EXPECT_FALSE(ring.contains(Point{0.5, 0}));  // of a − b the boundary of b is not a part
  EXPECT_TRUE(ring.contains(Point{0.5, 0}, 1e-12));
  EXPECT_TRUE(ring.contains(Point{1 + 1e-13, 0}, 1e-12));
  EXPECT_FALSE(ring.contains(Point{1 + 1e-11, 0}, 1e-12));
  EXPECT_FALSE(ring.contains(Point{0.5 - 1e-11, 0}, 1e-12));
}

TEST(Region, PointsWhereAPrimitiveIsUndefinedAreOutside) {
  const RegionEvaluator region(level_set(2 - sqrt(x_coordinate())));
  EXPECT_TRUE(region.contains(Point{1, 0}));
  EXPECT_FALSE(region.contains(Point{-1, 0}));
  EXPECT_FALSE(region.contains(Point{-1, 0}, 1e-9));
  EXPECT_NE(region.contains(Box{2, {-2, 0}, {-1, 1}}), Truth::yes);
}

}  // namespace
}  // namespace rfm
