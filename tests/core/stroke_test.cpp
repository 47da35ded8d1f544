#include "core/stroke.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <numbers>

#include "core/arc_spline.hpp"
#include "core/contour_distance.hpp"
#include "core/curved_polygon.hpp"
#include "core/error.hpp"
#include "core/evaluate.hpp"
#include "core/r_functions.hpp"
#include "core/tape.hpp"
#include "tests/core/chain_distance.hpp"
#include "tests/core/random_polygons.hpp"

namespace rfm {
namespace {

using test::distance_from;

// Inside is what lies within half of the width; both the region and the distance say so.
void expect_stroke(const std::vector<CircularEdge>& chain, bool closed, double width,
                   RandomPolygons& random, int points) {
  const std::vector<CurvedContour> contours = stroke_outline(chain, closed, width);
  const Tape region({implicit(curved_polygon(contours).region)}, {0}, 2);
  const Tape distance({contour_distance(contours)}, {0}, 2);
  for (int i = 0; i < points; ++i) {
    const CircularEdge& near = chain[random.integer(0, static_cast<int>(chain.size()) - 1)];
    const double step = width * random.real(0.1, 2);
    const Point x{near.from[0] + random.real(-step, step), near.from[1] + random.real(-step, step)};
    const double depth = width / 2 - distance_from(chain, x);
    if (std::fabs(depth) < 1e-8) continue;
    ASSERT_EQ(region.value(x) > 0, depth > 0) << x[0] << ", " << x[1];
    ASSERT_EQ(distance.value(x) > 0, depth > 0) << x[0] << ", " << x[1];
    // Outside, the distances from the stroke and from its curve differ by half of the width.
    if (depth < 0) {
      ASSERT_NEAR(distance.value(x), depth, 1e-9) << x[0] << ", " << x[1];
    }
  }
}

std::vector<Point> random_walk(RandomPolygons& random, int count) {
  std::vector<Point> points = {{0, 0}};
  double direction = 0;
  for (int i = 1; i < count; ++i) {
    direction += random.real(-2, 2);
    const double step = random.real(0.2, 1.5);
    points.push_back({points.back()[0] + step * std::cos(direction),
                      points.back()[1] + step * std::sin(direction)});
  }
  return points;
}

TEST(Strokes, OfASegmentAreStadiums) {
  RandomPolygons random(41);
  const auto chain = polyline_edges({{0, 0}, {2, 1}}, false);
  expect_stroke(chain, false, 0.7, random, 500);
  const auto contours = stroke_outline(chain, false, 0.7);
  ASSERT_EQ(contours.size(), 1);
  EXPECT_THAT(contours[0].names,
              testing::UnorderedElementsAre("left1", "right1", "start1", "start2", "end1", "end2"));
}

TEST(Strokes, OfPolylinesThatCrossThemselvesHoldWhatIsNear) {
  RandomPolygons random(42);
  int with_holes = 0;
  for (int i = 0; i < 60; ++i) {
    const auto chain =
        polyline_edges(random_walk(random, random.integer(2, 12)), i % 3 == 0 && i > 30);
    const double width = random.real(0.1, 0.8);
    with_holes += stroke_outline(chain, i % 3 == 0 && i > 30, width).size() > 1 ? 1 : 0;
    expect_stroke(chain, i % 3 == 0 && i > 30, width, random, 100);
    if (HasFatalFailure()) FAIL() << "polyline " << i;
  }
  EXPECT_GT(with_holes, 10);
}

TEST(Strokes, OfSplinesHoldWhatIsNear) {
  RandomPolygons random(43);
  for (int i = 0; i < 30; ++i) {
    std::vector<Point> points;
    const int count = random.integer(4, 12);
    for (int k = 0; k < count; ++k) {
      const double angle = 2 * std::numbers::pi * (k + random.real(-0.2, 0.2)) / count,
                   radius = random.real(1, 2);
      points.push_back({radius * std::cos(angle), radius * std::sin(angle)});
    }
    const bool closed = i % 2 == 0;
    expect_stroke(arc_spline(points, closed).edges, closed, random.real(0.05, 0.8), random, 100);
    if (HasFatalFailure()) FAIL() << "spline " << i;
  }
}

TEST(Strokes, HaveSidesByName) {
  const Outline outline =
      curved_polygon(stroke_outline(polyline_edges({{0, 0}, {2, 0}, {2, 2}}, false), false, 0.5));
  std::vector<std::string> names;
  for (const OutlineSide& side : outline.sides) names.push_back(side.name);
  EXPECT_THAT(names, testing::IsSupersetOf({"left", "right", "start", "end"}));
}

TEST(Strokes, NeedAWidthAndACurve) {
  EXPECT_THROW(stroke_outline(polyline_edges({{0, 0}, {1, 0}}, false), false, 0), InvalidArgument);
  EXPECT_THROW(polyline_edges({{1, 1}, {1, 1}}, false), InvalidArgument);
}

}  // namespace
}  // namespace rfm
