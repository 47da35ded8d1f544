#include "quadrature/height_direction.hpp"

#include <gmock/gmock.h>

#include "core/level_function.hpp"
#include "tests/quadrature/regions.hpp"

using namespace rfm;
using namespace rfm::test;

namespace {

HeightDirections heights_of(const std::vector<Field>& fields, const Point& low, const Point& high,
                            double flatness = 0.4, int dimension = 2) {
  Box box;
  box.dimension = dimension;
  box.low = low;
  box.high = high;
  std::vector<FunctionBounds> bounds;
  for (const Field& f : fields) bounds.push_back(LevelFunction(f, dimension).bounds(box));
  return find_heights(box, bounds, flatness);
}

const Field circle = 1 - square(x()) - square(y());

TEST(HeightDirection, OfACircleIsTheAxisNearestToItsNormal) {
  const HeightDirections right = heights_of({circle}, {0.9, -0.1, 0}, {1.1, 0.1, 0});
  EXPECT_EQ(right.proven_count, 1);
  EXPECT_EQ(right.proven[0], 0);
  const HeightDirections diagonal = heights_of({circle}, {0.6, 0.7, 0}, {0.7, 0.8, 0});
  EXPECT_EQ(diagonal.proven_count, 2);
  EXPECT_EQ(diagonal.proven[0], 1);
}

TEST(HeightDirection, IsRefusedWhereTheGradientTurns) {
  const HeightDirections whole = heights_of({circle}, {-1.5, -1.5, 0}, {1.5, 1.5, 0});
  EXPECT_EQ(whole.proven_count, 0);
}

TEST(HeightDirection, IsRefusedToSteepGraphs) {
  const Field steep = y() - 4 * x(), flat = y() - 0.1 * x();
  EXPECT_EQ(heights_of({steep, flat}, {0, 0, 0}, {1, 1, 0}, 0.2).proven[0], 1);
  EXPECT_EQ(heights_of({steep, flat}, {0, 0, 0}, {1, 1, 0}, 0.2).proven_count, 1);
  EXPECT_EQ(heights_of({steep, flat}, {0, 0, 0}, {1, 1, 0}, 0.3).proven_count, 0);
}

TEST(HeightDirection, ServesSurfacesIndependentOfIt) {
  const HeightDirections heights = heights_of({y() - 0.3 * x(), x() - 0.5}, {0, 0, 0}, {1, 1, 0});
  EXPECT_EQ(heights.proven_count, 1);
  EXPECT_EQ(heights.proven[0], 1);
}

TEST(HeightDirection, IsRefusedToSurfacesWithAKink) {
  // y > √(x²) is monotone in y, but its graph has a kink.
  EXPECT_EQ(heights_of({y() - sqrt(square(x()))}, {-1, -1, 0}, {1, 1, 0}, 0.1).proven_count, 0);
}

}  // namespace
