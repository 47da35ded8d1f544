#include "core/necessary_signs.hpp"

#include <gmock/gmock.h>

#include "core/primitives.hpp"

namespace rfm {
namespace {

// "k+" or "k-" for each.
std::vector<std::string> signs(const Region& region, const Box& box) {
  std::vector<std::string> list;
  for (const auto& [primitive, sign] : necessary_signs(RegionEvaluator(region), box))
    list.push_back(std::to_string(primitive) + (sign > 0 ? "+" : "-"));
  return list;
}

const Region disk = circle({0, 0}, 1), hole = circle({0.5, 0}, 0.2), right = circle({1, 0}, 1);

TEST(NecessarySigns, AreThoseOfAConjunction) {
  EXPECT_THAT(signs(disk - hole, Box{2, {-2, -2}, {2, 2}}), testing::ElementsAre("0+", "1-"));
  // The hole is decided in this box, the disk in that one.
  EXPECT_THAT(signs(disk - hole, Box{2, {-2, -2}, {0, 2}}), testing::ElementsAre("0+"));
  EXPECT_THAT(signs(disk - hole, Box{2, {0.4, -0.5}, {0.8, 0.5}}), testing::ElementsAre("1-"));
}

TEST(NecessarySigns, OfADisjunctionAreNoneUntilTheOtherPartIsExcluded) {
  EXPECT_THAT(signs(disk | right, Box{2, {-2, -2}, {2, 2}}), testing::IsEmpty());
  EXPECT_THAT(signs(disk | right, Box{2, {-2, -2}, {-0.1, 2}}), testing::ElementsAre("0+"));
  EXPECT_THAT(signs((disk & hole) | (disk & right), Box{2, {-2, -2}, {2, 2}}),
              testing::ElementsAre("0+"));
}

TEST(NecessarySigns, AreNoneWhereTheRegionIsEverywhereOrNowhere) {
  EXPECT_THAT(signs(disk, Box{2, {-0.1, -0.1}, {0.1, 0.1}}), testing::IsEmpty());
  EXPECT_THAT(signs(disk - hole, Box{2, {3, 3}, {4, 4}}), testing::IsEmpty());
}

}  // namespace
}  // namespace rfm
