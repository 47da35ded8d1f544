#include "core/contour.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <random>

#include "core/error.hpp"
#include "tests/core/random_polygons.hpp"

namespace rfm {
namespace {

using testing::ElementsAre;

TEST(Contour, IsCleanedOfRepeatedPointsAndTurnedCounterClockwise) {
  // A unit square clockwise; the second point twice, the first again at the end.
  const CleanContour clean = cleaned({{{0, 0}, {0, 1}, {0, 1}, {1, 1}, {1, 0}, {0, 0}}});
  EXPECT_TRUE(clean.reversed);
  ASSERT_EQ(clean.points.size(), 4u);
  EXPECT_EQ(twice_area(clean.points), 2);
  const std::vector<Point> original{{0, 0}, {0, 1}, {0, 1}, {1, 1}, {1, 0}, {0, 0}};
  for (std::size_t i = 0; i < 4; ++i) {
    const auto edge = static_cast<std::size_t>(clean.edges[i]);
    const Point &from = clean.points[i], &to = clean.points[(i + 1) % 4];
    EXPECT_TRUE((original[edge] == from && original[edge + 1] == to) ||
                (original[edge] == to && original[edge + 1] == from));
  }
}

TEST(Contour, WithoutAnAreaIsRefused) {
  EXPECT_THROW(cleaned({{{0, 0}, {1, 1}, {2, 2}}}), InvalidArgument);
  EXPECT_THROW(cleaned({{{0, 0}, {1, 1}, {0, 0}}}), InvalidArgument);
  EXPECT_THROW(cleaned({{{0, 0}, {1, NAN}, {1, 0}}}), InvalidArgument);
}

// On a lattice all is exact in whole numbers.
bool meet(const Segment& s, const Segment& t) {
  const auto side = [](const Segment& line, const Point& p) {
    const double turn = (line.to[0] - line.from[0]) * (p[1] - line.from[1]) -
                        (line.to[1] - line.from[1]) * (p[0] - line.from[0]);
    return (turn > 0) - (turn < 0);
  };
  for (int axis = 0; axis < 2; ++axis)
    if (std::max(s.from[axis], s.to[axis]) < std::min(t.from[axis], t.to[axis]) ||
        std::max(t.from[axis], t.to[axis]) < std::min(s.from[axis], s.to[axis]))
      return false;
  return side(s, t.from) * side(s, t.to) <= 0 && side(t, s.from) * side(t, s.to) <= 0;
}

TEST(Contour, IntersectingPairsAreFoundExactlyWhereThereAreAny) {
  std::mt19937 generator(6);
  int found_pairs = 0, none = 0;
  for (int trial = 0; trial < 600; ++trial) {
    std::vector<Segment> segments;
    const int count = 2 + static_cast<int>(generator() % 12);
    for (int i = 0; i < count; ++i) {
      const auto any = [&] { return static_cast<double>(generator() % 16); };
      Segment segment{{any(), any()}, {}};
      segment.to = {segment.from[0] + 1 + any() / 8, segment.from[1] + any() / 8};
      segments.push_back(segment);
    }
    const std::vector<int> next(segments.size(), -1);  // none follows another
    bool expected = false;
    for (int i = 0; i < count; ++i)
      for (int j = 0; j < i; ++j) expected = expected || meet(segments[i], segments[j]);
    const auto pair = intersecting_pair(segments, next);
    ASSERT_EQ(pair.has_value(), expected);
    if (pair) {
      EXPECT_TRUE(meet(segments[pair->first], segments[pair->second]));
    }
    ++(pair ? found_pairs : none);
  }
  EXPECT_GT(found_pairs, 50);
  EXPECT_GT(none, 50);
}

TEST(Contour, NeighboursMayShareTheirCornerOnly) {
  const std::vector<Segment> triangle{{{0, 0}, {2, 0}}, {{2, 0}, {1, 1}}, {{1, 1}, {0, 0}}};
  EXPECT_FALSE(intersecting_pair(triangle, std::vector<int>{1, 2, 0}));
  const std::vector<Segment> folded{{{0, 0}, {2, 0}}, {{2, 0}, {1, 0}}};
  EXPECT_TRUE(intersecting_pair(folded, std::vector<int>{1, -1}));
}

TEST(Contour, WindsAroundThePointsInsideOfSimplePolygons) {
  RandomPolygons random(12);
  int inside = 0;
  for (int trial = 0; trial < 60; ++trial) {
    const auto kind =
        static_cast<RandomPolygons::Kind>(trial % static_cast<int>(RandomPolygons::Kind::count));
    const std::vector<Point> polygon = random.next(kind);
    for (int i = 0; i < 50; ++i) {
      const Point p{random.real(-1.5, 1.5), random.real(-1.5, 1.5)};
      long double turns = 0;  // the angle under which the polygon is seen
      for (std::size_t k = 0; k < polygon.size(); ++k) {
        const Point &a = polygon[k], &b = polygon[(k + 1) % polygon.size()];
        const long double ax = a[0] - p[0], ay = a[1] - p[1], bx = b[0] - p[0], by = b[1] - p[1];
        turns += std::atan2(ax * by - ay * bx, ax * bx + ay * by);
      }
      const bool expected = std::fabs(turns) > 3;
      EXPECT_EQ(winds_around(polygon, p), expected);
      inside += expected;
    }
  }
  EXPECT_GT(inside, 100);
}

}  // namespace
}  // namespace rfm
