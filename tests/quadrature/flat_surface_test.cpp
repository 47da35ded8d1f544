#include "quadrature/flat_surface.hpp"

#include <gmock/gmock.h>

#include "tests/quadrature/regions.hpp"

using namespace rfm;
using namespace rfm::test;

namespace {

std::optional<FlatSurface> flat(const Field& field, const Box& box) {
  const LevelFunction level(field, box.dimension);
  const Surface surface(level);
  return find_flat_surface(box, surface, surface.bounds(box));
}

TEST(FlatSurfaces, AreFoundWhateverTheyAreMultipliedBy) {
  const Box box{2, {0.1, -0.2, 0}, {0.4, 0.3, 0}};
  const auto plane = flat((y() - 0.05) * (3 + square(x())), box);
  ASSERT_TRUE(plane);
  EXPECT_TRUE(plane->is_sure);
  EXPECT_NEAR(plane->plane.value({0.2, 0.05}), 0, 1e-15);
  EXPECT_GT(plane->plane.value({0.2, 0.06}), 0);
  EXPECT_TRUE(plane->plane.bounds(box).gradient[0].is_zero());
  const auto other_side = flat((0.05 - y()) * exp(x()), box);
  ASSERT_TRUE(other_side);
  EXPECT_LT(other_side->plane.value({0.2, 0.06}), 0);
}

TEST(FlatSurfaces, AreNotSeenInWhatIsBentByMoreThanRounding) {
  const Box box{2, {0.1, -0.2, 0}, {0.4, 0.3, 0}};
  EXPECT_FALSE(flat(y() - 1e-6 * square(x()), box));
  EXPECT_FALSE(flat(y() - 1e-9 * x(), box));
  // Known to be flat without being asked.
  EXPECT_FALSE(flat(y() - 0.05, box));
}

TEST(FlatSurfaces, OnASideBelongToTheBoxToWhichTheSurfaceBelongs) {
  // Zero on the side is positive: the box below ends there, for the box above it is nothing.
  const Field up = y() * (3 + square(x()));
  const Box above{2, {0.1, 0, 0}, {0.4, 0.3, 0}}, below{2, {0.1, -0.3, 0}, {0.4, 0, 0}};
  const auto seen_above = flat(up, above), seen_below = flat(up, below);
  ASSERT_TRUE(seen_above && seen_below);
  EXPECT_TRUE(seen_above->is_sure && seen_below->is_sure);
  EXPECT_EQ(seen_above->plane.bounds(above).value.low, 0);
  EXPECT_EQ(seen_below->plane.bounds(below).value.high, 0);
  const auto down_above = flat(-up, above), down_below = flat(-up, below);
  ASSERT_TRUE(down_above && down_below);
  EXPECT_EQ(down_above->plane.bounds(above).value.high, 0);
  EXPECT_EQ(down_below->plane.bounds(below).value.low, 0);
  // Negative on the side, by less than rounding: the box above has it, and the one below is
  // negative everywhere.
  const Field lifted = (y() - 1e-17) * (3 + square(x()));
  const auto lifted_above = flat(lifted, above);
  ASSERT_TRUE(lifted_above);
  EXPECT_LT(lifted_above->plane.bounds(above).value.low, 0);
  EXPECT_LT(LevelFunction(lifted, 2).bounds(below).value.high, 0);
}

TEST(FlatSurfaces, AreFoundInSpace) {
  const Box box{3, {-0.1, 0.2, -0.2}, {0.1, 0.5, 0.1}};
  const auto plane = flat(-(z() + 0.05) * exp(x() * y()), box);
  ASSERT_TRUE(plane);
  EXPECT_GT(plane->plane.value({0, 0.3, -0.06}), 0);
  EXPECT_NEAR(plane->plane.value({0, 0.3, -0.05}), 0, 1e-15);
}

}  // namespace
