#include "core/surroundings.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "core/primitives.hpp"

namespace rfm {
namespace {

Surroundings look(const Region& region, const Point& at) {
  return surroundings(RegionEvaluator(region), at, 1e-10, 1e-6);
}

TEST(Surroundings, OfRegularPointsAreOneSideOrBoth) {
  const Region square = box({0, 0}, {1, 1});
  const Surroundings inside = look(square, {0.5, 0.5}), outside = look(square, {1.5, 0.5});
  EXPECT_TRUE(inside.any_inside && !inside.any_outside && inside.vanishing.empty());
  EXPECT_TRUE(!outside.any_inside && outside.any_outside);
  const Surroundings side = look(square, {1, 0.3});
  EXPECT_TRUE(side.any_inside && side.any_outside);
  EXPECT_EQ(side.vanishing, (std::vector<int>{1}));
  EXPECT_EQ(side.signs[1], Truth::unknown);
  EXPECT_EQ(side.signs[0], Truth::yes);
  EXPECT_EQ(look(square, {1, 1}).vanishing, (std::vector<int>{1, 3}));
}

TEST(Surroundings, OfASharedSideAreAllInside) {
  const Region two = box({0, 0}, {1, 1}) | box({1, 0}, {2, 1});
  EXPECT_FALSE(look(two, {1, 0.5}).any_outside);
  EXPECT_TRUE(look(two, {1, 0}).any_outside);  // its end
  const Region bricks = box({0, 0, 0}, {1, 1, 1}, 3) | box({1, 0, 0}, {2, 1, 1}, 3);
  EXPECT_FALSE(look(bricks, {1, 0.5, 0.5}).any_outside);
  EXPECT_TRUE(look(bricks, {1, 1, 0.5}).any_outside);
}

TEST(Surroundings, OfADanglingSegmentAreAllOutside) {
  const Region line = half_plane({0, 0}, {1, 0}) & half_plane({0, 0}, {-1, 0});
  const Surroundings around = look(line, {0, 0.2});
  EXPECT_FALSE(around.any_inside);
  EXPECT_TRUE(around.any_outside);
}

// Far thinner than the 64 directions of a circle, or the 128 of a sphere: found by the tangents.
TEST(Surroundings, SeeWedgesThatAreThin) {
  for (const double angle : {1e-2, 1e-4, 1e-6}) {
    const double c = std::cos(angle), s = std::sin(angle);
    const Region wedge = half_plane({0, 0}, {0, 1}) & half_plane({0, 0}, {s, -c});
    EXPECT_TRUE(look(wedge, {0, 0}).any_inside) << angle;
    EXPECT_TRUE(look(!wedge, {0, 0}).any_outside) << angle;
  }
  const Region needle = half_space({0, 0, 0}, {0, 0, 1}) &
                        half_space({0, 0, 0}, {std::sin(0.03), 0, -std::cos(0.03)}) &
                        half_space({0, 0, 0}, {0.2, 1, 0});
  EXPECT_TRUE(look(needle, {0, 0, 0}).any_inside);
  EXPECT_TRUE(look(needle, {0, 0, 0}).any_outside);
}

}  // namespace
}  // namespace rfm
