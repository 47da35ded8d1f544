#include "core/line_groups.hpp"

#include <gmock/gmock.h>

#include <cmath>

namespace rfm {
namespace {

using testing::ElementsAre;

TEST(LineGroups, HoldTheSegmentsOfOneLineInOneDirection) {
  // A comb: teeth end on y = 1, walked in the same direction; its back on y = 0 the other way.
  const std::vector<Segment> segments{{{3, 1}, {2, 1}}, {{2, 1}, {2, 0.5}}, {{1, 1}, {0, 1}},
                                      {{0, 0}, {3, 0}}, {{0, 1}, {3, 1}},   {{0, 0.5}, {0, 0}}};
  const LineGroups groups = group_by_line(segments);
  EXPECT_EQ(groups.group[0], groups.group[2]);
  EXPECT_NE(groups.group[0], groups.group[4]);  // the same line backwards
  EXPECT_NE(groups.group[0], groups.group[3]);
  EXPECT_THAT(groups.members[static_cast<std::size_t>(groups.group[0])], ElementsAre(0, 2));
  ASSERT_EQ(groups.members.size(), 5u);
}

TEST(LineGroups, SpanTheEndsThatAreFarthestApart) {
  const std::vector<Segment> segments{{{1, 2}, {2, 4}}, {{3, 6}, {5, 10}}, {{-1, -2}, {0, 0}}};
  const LineGroups groups = group_by_line(segments);
  ASSERT_EQ(groups.lines.size(), 1u);
  EXPECT_EQ(groups.lines[0].from, (Point{-1, -2}));
  EXPECT_EQ(groups.lines[0].to, (Point{5, 10}));
}

TEST(LineGroups, AreTurnedAndMovedWithTheWhole) {
  const double c = std::cos(0.3), s = std::sin(0.3);
  const auto turned = [&](double x, double y) {
    return Point{c * x - s * y + 7, s * x + c * y - 3};
  };
  const std::vector<Segment> segments{{turned(0, 0), turned(1, 0)},
                                      {turned(4, 0), turned(6, 0)},
                                      {turned(0, 1e-9), turned(1, 1e-9)},
                                      {turned(2, 0), turned(3, 1e-9)}};
  const LineGroups groups = group_by_line(segments);
  EXPECT_EQ(groups.group[0], groups.group[1]);
  EXPECT_NE(groups.group[0], groups.group[2]);  // 10⁻⁹ beside it
  EXPECT_NE(groups.group[0], groups.group[3]);  // turned by 10⁻⁹
}

}  // namespace
}  // namespace rfm
