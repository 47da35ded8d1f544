#include "problems/pictures/line_picture.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "core/primitives.hpp"

namespace rfm {
namespace {

TEST(IntervalsOfALine, AreThoseOfTheRegionToRounding) {
  // [0, 1/3] ∪ [√½, 2) without (1.2, 1.7).
  const Field x = x_coordinate();
  const Region region =
      (box({0}, {1.0 / 3}, 1).named("a") |
       (level_set(2.0 * x * x - 1.0, 1).named("b") & box({0}, {2}, 1).named("c"))) -
      box({1.2}, {1.7}, 1).named("d");
  const std::vector<Interval> found =
      intervals_of(RegionEvaluator(region), {1, {-0.5, 0, 0}, {2.5, 0, 0}});
  const std::vector<Interval> expected = {{0, 1.0 / 3}, {std::sqrt(0.5), 1.2}, {1.7, 2}};
  ASSERT_EQ(found.size(), expected.size());
  for (std::size_t i = 0; i < found.size(); ++i) {
    EXPECT_NEAR(found[i].low, expected[i].low, 1e-14);
    EXPECT_NEAR(found[i].high, expected[i].high, 1e-14);
  }
}

TEST(IntervalsOfALine, ReachTheBoundsThatTheyFill) {
  const std::vector<Interval> found =
      intervals_of(RegionEvaluator(box({-1}, {3}, 1).named("bar")), {1, {-1, 0, 0}, {3, 0, 0}});
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].low, -1);
  EXPECT_EQ(found[0].high, 3);
}

}  // namespace
}  // namespace rfm
