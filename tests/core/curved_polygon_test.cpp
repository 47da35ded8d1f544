#include "core/curved_polygon.hpp"

#include <gmock/gmock.h>

#include <array>
#include <cmath>
#include <numbers>

#include "core/bounding_box.hpp"
#include "core/error.hpp"
#include "core/evaluate.hpp"
#include "core/r_functions.hpp"
#include "core/tape.hpp"
#include "tests/core/random_contours.hpp"

namespace rfm {
namespace {

using testing::HasSubstr;
constexpr double pi = std::numbers::pi;

// Signs at random points against the winding number of a fine polygon, away from which by less than
// it errs nothing is asked; zeros on the curve.
void expect_right(const CurvedContour& contour, RandomPolygons& random, int points) {
  const Region region = curved_polygon({contour}).region;
  const Field function = implicit(region);
  const std::vector<Point> fine = traced(contour, 400);
  Point low = fine[0], high = fine[0];
  for (const Point& p : fine)
    for (int axis = 0; axis < 2; ++axis) {
      low[axis] = std::min(low[axis], p[axis]);
      high[axis] = std::max(high[axis], p[axis]);
    }
  const double size = std::max(high[0] - low[0], high[1] - low[1]);
  for (int axis = 0; axis < 2; ++axis) {
    ASSERT_LE(region.enclosure()->low[axis], low[axis] + 1e-12 * size);
    ASSERT_GE(region.enclosure()->high[axis], high[axis] - 1e-12 * size);
  }
  const Tape tape({function}, {0}, 2);
  const auto value = [&](const Point& p) { return tape.value(p); };
  for (int i = 0; i < points; ++i) {
    Point p{random.real(low[0], high[0]), random.real(low[1], high[1])};
    if (i % 2 == 0) {  // near the curve
      const Point& on = fine[random.integer(0, static_cast<int>(fine.size()) - 1)];
      const double step = size * std::pow(10, random.real(-4, -1));
      p = {on[0] + random.real(-step, step), on[1] + random.real(-step, step)};
    }
    double distance = INFINITY;
    for (std::size_t k = 0; k < fine.size(); ++k)
      distance = std::min(distance, distance_from(fine[k], fine[(k + 1) % fine.size()], p));
    // Chords of 1/400 of an edge are off by the square of that, at most 1.6e-5 of a semicircle.
    if (distance < 1e-4 * size) continue;
    ASSERT_EQ(value(p) > 0, winds_around(fine, p)) << p[0] << " " << p[1];
    ASSERT_NE(value(p), 0);
  }
  for (int i = 0; i < 40; ++i) {
    const Point& on = fine[random.integer(0, static_cast<int>(fine.size()) - 1)];
    ASSERT_NEAR(value(on), 0, 1e-12 * size);
  }
}

CurvedContour stadium() { return {{{0, 0}, {2, 0}, {2, 1}, {0, 1}}, {{}, {1.0}, {}, {1.0}}}; }

TEST(CurvedPolygons, AStadiumHasTwoSemicircles) {
  const Region region = curved_polygon({stadium()}).region;
  const RegionEvaluator evaluator(region);
  EXPECT_TRUE(evaluator.contains(Point{2.49, 0.5}));
  EXPECT_FALSE(evaluator.contains(Point{2.51, 0.5}));
  EXPECT_TRUE(evaluator.contains(Point{-0.35, 0.85}));
  EXPECT_FALSE(evaluator.contains(Point{-0.36, 0.86}));
  for (const auto& primitive : region.primitives())
    if (primitive->name == "edge2") {
      EXPECT_NEAR(value_at(primitive->function, {2, 0.5}), 0.25, 1e-15);
    }
  RandomPolygons random(1);
  expect_right(stadium(), random, 500);
}

TEST(CurvedPolygons, OfTwoPointsAreLensesAndCircles) {
  RandomPolygons random(2);
  expect_right({{{0, 0}, {1, 0}}, {{0.3}, {0.5}}}, random, 300);
  expect_right({{{0, 0}, {1, 0}}, {{-0.3}, {0.5}}}, random, 300);  // a crescent
  expect_right({{{0, 0}, {1, 0}}, {{}, {1.0}}}, random, 300);      // half a disk
  expect_right({{{0, 0}, {1, 0}}, {{}, {2.5}}}, random, 300);      // more than half
  const Region disk = curved_polygon({{{{-1, 0}, {1, 0}}, {{1.0}, {1.0}}}}).region;
  RandomPolygons again(3);
  expect_right({{{-1, 0}, {1, 0}}, {{1.0}, {1.0}}}, again, 300);
}

TEST(CurvedPolygons, HaveTheBoundingBoxOfTheirArcs) {
  const auto expect = [](const CurvedContour& contour, const Point& low, const Point& high) {
    const Region region = curved_polygon({contour}).region;
    ASSERT_TRUE(region.enclosure());
    const Box found = bounding_box(RegionEvaluator(region));
    for (int axis = 0; axis < 2; ++axis) {
      EXPECT_LE(region.enclosure()->low[axis], low[axis]);
      EXPECT_GE(region.enclosure()->high[axis], high[axis]);
      EXPECT_NEAR(found.low[axis], low[axis], 1e-12);
      EXPECT_NEAR(found.high[axis], high[axis], 1e-12);
    }
  };
  expect(stadium(), {-0.5, 0}, {2.5, 1});
  // An arc of sagitta 1.25 over a chord of 1, of radius 0.725.
  expect({{{0, 0}, {1, 0}}, {{}, {2.5}}}, {-0.225, 0}, {1.225, 1.25});
}

TEST(CurvedPolygons, InflectionsWithACommonTangent) {
  RandomPolygons random(4);
  // A wave of two semicircles over a box.
  expect_right({{{0, 0}, {4, 0}, {4, 2}, {2, 2}, {0, 2}}, {{}, {}, {0.4}, {-0.4}, {}}}, random,
               500);
  // A wheel whose teeth and gaps pass into each other smoothly.
  for (const int teeth : {3, 5, 9}) {
    CurvedContour wheel;
    const double gap = 0.5, tooth = gap + pi / teeth;
    for (int i = 0; i < 2 * teeth; ++i) {
      const double angle = pi * i / teeth;
      wheel.points.push_back({std::cos(angle), std::sin(angle)});
      wheel.edges.push_back({std::tan((i % 2 == 0 ? tooth : -gap) / 2)});
    }
    expect_right(wheel, random, 500);
  }
}

TEST(CurvedPolygons, ConicsOfAllKinds) {
  RandomPolygons random(5);
  for (const double weight : {0.3, std::sqrt(0.5), 1.0, 2.5})
    for (const double height : {-0.4, 1.5}) {
      CurvedContour contour{{{0, 0}, {2, 0}, {2, 1}, {0, 1}}, {{}, {}, {}, {}}};
      contour.edges[2].conic = EdgeCurve::Conic{{1.2, 1 + height}, weight};
      expect_right(contour, random, 400);
    }
  // A quarter of an ellipse: 4 w² a c − b² with w = √½ is that of x²/4 + y².
  CurvedContour quarter{{{0, 0}, {2, 0}, {0, 1}}, {{}, {}, {}}};
  quarter.edges[1].conic = EdgeCurve::Conic{{2, 1}, std::sqrt(0.5)};
  const Region region = curved_polygon({quarter}).region;
  for (const auto& primitive : region.primitives())
    if (primitive->name == "edge2") {
      for (const double t : {0.1, 0.7, 2.0, 4.0})
        EXPECT_NEAR(value_at(primitive->function, {2 * std::cos(t), std::sin(t)}), 0, 1e-14);
    }
}

TEST(CurvedPolygons, AreTheSameEitherWayRound) {
  CurvedContour contour = stadium(), reversed = contour;
  std::ranges::reverse(reversed.points);
  reversed.edges = {{}, {-1.0}, {}, {-1.0}};
  const RegionEvaluator a(curved_polygon({contour}).region), b(curved_polygon({reversed}).region);
  RandomPolygons random(6);
  for (int i = 0; i < 200; ++i) {
    const Point p{random.real(-1, 3), random.real(-0.5, 1.5)};
    EXPECT_EQ(a.contains(p), b.contains(p));
  }
}

TEST(CurvedPolygons, ThatAreNotSimpleAreRefused) {
  const auto refused = [](const CurvedContour& contour, const std::string& reason) {
    try {
      curved_polygon({contour});
      FAIL() << "accepted";
    } catch (const InvalidArgument& error) {
      EXPECT_THAT(error.what(), HasSubstr(reason));
    }
  };
  // An arc that dips through the side below, and a cusp.
  refused({{{0, 0}, {2, 0}, {2, 0.5}, {0, 0.5}}, {{}, {}, {-0.8}, {}}}, "edge1 and edge3");
  refused({{{0, 0}, {2, 0}, {0, 2}}, {{}, {1.0}, {-1.0}}}, "cross, touch or nearly touch");
  refused({{{0, 0}, {0, 0}}, {{1.0}, {1.0}}}, "two different points");
}

// Signs at points of the plane, half of them next to the curve down to 1e-10 of its size, and zeros
// on it, in long double.
void compare(const CurvedContour& contour, RandomPolygons& random, int points) {
  const Tape tape({implicit(curved_polygon({contour}).region)}, {0}, 2);
  const std::vector<Point> on = traced(contour, 25);
  double size = 0;
  for (const Point& p : on) size = std::max({size, 2 * std::fabs(p[0]), 2 * std::fabs(p[1])});
  const auto next = [&]() -> const Point& {
    return on[random.integer(0, static_cast<int>(on.size()) - 1)];
  };
  for (int i = 0; i < points; ++i) {
    const double step = size * (i % 2 == 0 ? std::pow(10, random.real(-10, -1)) : 1);
    const Point near = next();
    const Point at{near[0] + random.real(-step, step), near[1] + random.real(-step, step)};
    if (distance_from(contour, at) < 1e-12 * size) continue;
    ASSERT_EQ(tape.value(at) > 0, is_inside(contour, at)) << at[0] << ", " << at[1];
    ASSERT_NE(tape.value(at), 0);
  }
  for (int i = 0; i < 30; ++i) ASSERT_NEAR(tape.value(next()), 0, 1e-13 * size);
}

// What is refused crosses itself beside a corner, closer than the generator can see.
void agree(int count) {
  RandomPolygons random(23);
  int refused = 0;
  for (int i = 0; i < count; ++i) {
    const CurvedContour contour = random_contour(random);
    try {
      compare(contour, random, 1000);
    } catch (const InvalidArgument& error) {
      ++refused;
      EXPECT_TRUE(crosses_itself(contour, 20000)) << "contour " << i << ": " << error.what();
    }
    if (testing::Test::HasFatalFailure()) FAIL() << "contour " << i;
  }
  testing::Test::RecordProperty("refused", refused);
  EXPECT_LE(refused, 0.02 * count);
}

TEST(CurvedPolygons, SignsAreThoseOfTheWindingNumber) { agree(40); }
TEST(LongCurvedPolygons, SignsAreThoseOfTheWindingNumber) { agree(1000); }

}  // namespace
}  // namespace rfm
