#include "problems/pictures/visible_places.hpp"

#include <gmock/gmock.h>

using namespace rfm;

namespace {

TEST(VisiblePlaces, AreFarthestFromOtherNumbersAndTheSides) {
  // A 9 × 7 block of zeros in a picture of 15 × 11; a single one.
  NumberedPixels pixels{15, 11, std::vector<int>(15 * 11, -1)};
  for (int y = 2; y < 9; ++y)
    for (int x = 4; x < 13; ++x) pixels.number[y * 15 + x] = 0;
  pixels.number[0] = 1;
  const auto places = visible_places(pixels, 3);
  ASSERT_TRUE(places[0] && places[1]);
  EXPECT_FALSE(places[2]);
  EXPECT_EQ(places[0]->radius, 4);  // rows 2 … 8: the middle row is the fourth from either side
  EXPECT_EQ(places[0]->place.y, 5.5);
  EXPECT_EQ(places[0]->place.x, 7.5);  // the leftmost that is four from the left side
  EXPECT_EQ(places[1]->radius, 1);
  EXPECT_EQ(places[1]->place.x, 0.5);
}

}  // namespace
