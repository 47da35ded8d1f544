#include "core/closed_along.hpp"

#include <gtest/gtest.h>

#include "core/error.hpp"
#include "core/primitives.hpp"

namespace rfm {
namespace {

const Box bounds{2, {-2, -2}, {2, 2}};
const Region above = half_plane({0, 0}, {0, 1}), below = half_plane({0, 0}, {0, -3});
const Region right = half_plane({0, 0}, {1, 0});

bool holds(const Region& region, const std::vector<int>& vanishing, const Point& at) {
  const RegionEvaluator evaluator(region);
  return RegionEvaluator(closed_along(evaluator, vanishing, bounds)).contains(at);
}

TEST(ClosedAlong, ASideBelongsToTheRegionOnBothSidesOfRounding) {
  const Region quadrant = above & right;
  for (const double off : {-1e-17, 0.0, 1e-17}) {
    EXPECT_TRUE(holds(quadrant, {0}, {0.5, off}));
    EXPECT_FALSE(holds(quadrant, {0}, {-0.5, off}));
  }
}

TEST(ClosedAlong, PrimitivesThatVanishNowhereAlongItDecideAsTheyAre) {
  const Region quadrant = above & right;
  EXPECT_TRUE(holds(quadrant, {}, {0.5, 0.5}));
  EXPECT_FALSE(holds(quadrant, {}, {0.5, -1e-17}));
}

TEST(ClosedAlong, MultiplesOfOnePrimitiveHaveTheirSignsTogether) {
  // On neither side of the line there is anything of the first, of the second there is on both.
  EXPECT_FALSE(holds(above & below & right, {0, 1}, {0.5, 0}));
  EXPECT_TRUE(holds((above | below) & right, {0, 1}, {0.5, 0}));
  EXPECT_FALSE(holds((above | below) & right, {0, 1}, {-0.5, 0}));
}

TEST(ClosedAlong, MoreThanEightSurfacesAreRefused) {
  Region many = right;
  std::vector<int> numbers{0};
  for (int i = 1; i <= 8; ++i) {
    many = many & half_plane({0, 0}, {1, 0.1 * i});
    numbers.push_back(i);
  }
  EXPECT_THROW(closed_along(RegionEvaluator(many), numbers, bounds), InvalidArgument);
  numbers.pop_back();
  EXPECT_NO_THROW(closed_along(RegionEvaluator(many), numbers, bounds));
}

}  // namespace
}  // namespace rfm
