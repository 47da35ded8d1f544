#include "core/box.hpp"

#include <gmock/gmock.h>

namespace rfm {
namespace {

const Box brick{3, {0, -1, 2}, {2, 0, 5}};

TEST(Box, MeasuresItself) {
  EXPECT_EQ(brick.length(0), 2);
  EXPECT_EQ(brick.longest_axis(), 2);
  EXPECT_EQ(brick.longest_side(), 3);
  EXPECT_EQ(brick.measure(), 6);
  EXPECT_EQ((Box{2, {0, -1}, {2, 0}}).measure(), 2);
  EXPECT_EQ((Box{1, {0}, {2}}).measure(), 2);
  EXPECT_THAT(brick.center(), testing::ElementsAre(1, -0.5, 3.5));
}

TEST(Box, AxesBeyondTheDimensionDoNotCount) {
  const Box flat{2, {0, 0, 0}, {1, 1, 50}};
  EXPECT_EQ(flat.longest_axis(), 0);
  EXPECT_THAT(flat.center(), testing::ElementsAre(0.5, 0.5, 0));
  EXPECT_TRUE(flat.contains({0.5, 0.5, 99}));
}

TEST(Box, IsClosed) {
  EXPECT_TRUE(brick.contains({0, 0, 5}));
  EXPECT_FALSE(brick.contains({0, 1e-9, 5}));
  EXPECT_FALSE(brick.contains({0, NAN, 5}));
}

TEST(Box, HalvesShareTheMiddleAndMakeUpTheWhole) {
  for (int axis = 0; axis < 3; ++axis) {
    const auto [low, high] = bisect(brick, axis);
    EXPECT_EQ(low.high[axis], high.low[axis]);
    EXPECT_EQ(low.low, brick.low);
    EXPECT_EQ(high.high, brick.high);
    EXPECT_EQ(low.measure() + high.measure(), brick.measure());
  }
}

}  // namespace
}  // namespace rfm
