#include "core/stroke_region.hpp"

#include <gmock/gmock.h>

#include <cmath>

#include "core/arc_spline.hpp"
#include "core/bounding_box.hpp"
#include "core/error.hpp"
#include "core/stroke.hpp"
#include "tests/core/chain_distance.hpp"
#include "tests/core/random_polygons.hpp"

namespace rfm {
namespace {

using test::distance_from;

// Inside is what lies within half of the width.
void expect_near(const Region& region, const std::vector<CircularEdge>& chain, double width,
                 RandomPolygons& random, int points) {
  const RegionEvaluator evaluator(region);
  for (int i = 0; i < points; ++i) {
    const Point x{random.real(-1, 5), random.real(-1, 5)};
    const double depth = width / 2 - distance_from(chain, x);
    if (std::fabs(depth) < 1e-7) continue;
    ASSERT_EQ(evaluator.contains(x), depth > 0) << x[0] << ", " << x[1];
  }
}

bool is_union(const Outline& outline) {
  return std::ranges::any_of(outline.region.primitives(), [](const auto& primitive) {
    return primitive->name.starts_with("separator");
  });
}

// Points on a lattice: offsets lie on one line, arcs pass through corners, and chains run back
// along themselves.
void expect_lattice_strokes(int seed, int count) {
  RandomPolygons random(seed);
  int unions = 0;
  for (int i = 0; i < count; ++i) {
    std::vector<Point> points(random.integer(3, 8));
    for (Point& p : points)
      p = {static_cast<double>(random.integer(0, 4)), static_cast<double>(random.integer(0, 4))};
    if (std::ranges::all_of(points, [&](const Point& p) { return p == points[0]; })) continue;
    const bool closed = i % 3 == 0;
    const double width = i % 2 == 0 ? 0.5 : 0.25;
    const auto chain = polyline_edges(points, closed);
    const Outline outline = stroke(chain, closed, width);
    unions += is_union(outline) ? 1 : 0;
    expect_near(outline.region, chain, width, random, 500);
    expect_near(stroke_union(chain, closed, width).region, chain, width, random, 100);
    if (testing::Test::HasFatalFailure()) FAIL() << "polyline " << i;
  }
  EXPECT_LT(unions, 0.1 * count);
}

TEST(StrokeRegions, OfLatticePointsHoldWhatIsNear) { expect_lattice_strokes(1, 40); }
TEST(LongStrokeRegions, OfLatticePointsHoldWhatIsNear) { expect_lattice_strokes(2, 2000); }

TEST(StrokeRegions, ThatTouchThemselvesAreUnions) {
  // The last point comes as near to the first segment as the width.
  const auto chain = polyline_edges({{0, 0}, {4, 0}, {4, 2}, {2, 2}, {2, 0.5}}, false);
  RandomPolygons random(3);
  const Outline outline = stroke(chain, false, 0.5);
  expect_near(outline.region, chain, 0.5, random, 2000);
  for (const Outline& one : {outline, stroke_union(chain, false, 0.5)}) {
    const Box box = bounding_box(RegionEvaluator(one.region));
    EXPECT_NEAR(box.low[0], -0.25, 1e-12);
    EXPECT_NEAR(box.high[0], 4.25, 1e-12);
    EXPECT_NEAR(box.low[1], -0.25, 1e-12);
    EXPECT_NEAR(box.high[1], 2.25, 1e-12);
    std::vector<std::string> names;
    for (const OutlineSide& side : one.sides) names.push_back(side.name);
    EXPECT_THAT(names, testing::IsSupersetOf({"left", "right", "start", "end"}));
  }
}

TEST(StrokeRegions, UnionsOfSplinesHoldWhatIsNear) {
  RandomPolygons random(4);
  for (int i = 0; i < 20; ++i) {
    std::vector<Point> points(random.integer(3, 7));
    for (Point& p : points) p = {random.real(0, 4), random.real(0, 4)};
    const auto chain = arc_spline(points, i % 2 == 0).edges;
    const double width = random.real(0.05, 0.8);
    expect_near(stroke_union(chain, i % 2 == 0, width).region, chain, width, random, 300);
    expect_near(stroke(chain, i % 2 == 0, width).region, chain, width, random, 300);
    if (testing::Test::HasFatalFailure()) FAIL() << "spline " << i;
  }
}

// Left of the chain and right of it: a region that lacks a part of the stroke, or has more, is
// seen.
TEST(StrokeRegions, AreToldFromOthers) {
  const auto chain = polyline_edges({{0, 0}, {2, 0}, {2, 2}}, false);
  EXPECT_TRUE(is_stroke(stroke(chain, false, 0.5).region, chain, chain, 0.5));
  EXPECT_FALSE(is_stroke(stroke(chain, false, 0.4).region, chain, chain, 0.5));
  const auto triangle = polyline_edges({{0, 0}, {2, 0}, {2, 2}}, true);
  EXPECT_FALSE(is_stroke(stroke(triangle, true, 0.5).region, chain, triangle, 0.5));
  EXPECT_THROW(stroke(chain, false, 0), InvalidArgument);
}

}  // namespace
}  // namespace rfm
