#include "core/curved_polygon.hpp"

#include <gmock/gmock.h>

#include <array>
#include <cmath>
#include <numbers>

#include "core/arc_spline.hpp"
#include "core/bounding_box.hpp"
#include "core/error.hpp"
#include "core/evaluate.hpp"
#include "core/r_functions.hpp"
#include "core/tape.hpp"
#include "tests/core/random_contours.hpp"
#include "tests/core/rounded_outlines.hpp"

namespace rfm {
namespace {

using testing::HasSubstr;
constexpr double pi = std::numbers::pi;

Box extent_of(const std::vector<Point>& points) {
  Box box{2, points[0], points[0]};
  for (const Point& point : points)
    for (int axis = 0; axis < 2; ++axis) {
      box.low[axis] = std::min(box.low[axis], point[axis]);
      box.high[axis] = std::max(box.high[axis], point[axis]);
    }
  return box;
}

// Signs at random points against the winding number of a fine polygon, away from which by less than
// it errs nothing is asked; zeros on the curve.
void expect_right(const CurvedContour& contour, RandomPolygons& random, int points) {
  const Region region = curved_polygon({contour}).region;
  const Field function = implicit(region);
  const std::vector<Point> fine = traced(contour, 400);
  const Box extent = extent_of(fine);
  const Point &low = extent.low, &high = extent.high;
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

CurvedContour of_spline(const std::vector<Point>& points) {
  CurvedContour contour;
  for (const CircularEdge& edge : arc_spline(points, true).edges) {
    contour.points.push_back(edge.from);
    contour.edges.push_back({edge.bulge});
  }
  return contour;
}

/// NACA 00xx, its trailing edge sharp: beside it the closed spline has inflections.
std::vector<Point> airfoil(int count, double thickness, double unit) {
  std::vector<Point> points;
  for (int k = 0; k < 2 * count; ++k) {
    const double x = (1 + std::cos(pi * k / count)) / 2;
    const double y = 5 * thickness *
                     (.2969 * std::sqrt(x) - .126 * x - .3516 * x * x + .2843 * x * x * x -
                      .1036 * x * x * x * x);
    points.push_back(rounded({x, k < count ? y : -y}, unit));
  }
  return points;
}

/// A band of constant height along a sine.
std::vector<Point> snake(RandomPolygons& random, double unit) {
  const int count = random.integer(6, 20);
  const double height = std::pow(10, random.real(-3, -0.7)), size = random.real(0.1, 0.5),
               waves = random.real(1, 6);
  std::vector<Point> points, back;
  for (int k = 0; k < count; ++k) {
    const double x = 3.0 * k / (count - 1), y = size * std::sin(waves * x);
    points.push_back(rounded({x, y}, unit));
    back.push_back(rounded({x, y + height}, unit));
  }
  points.insert(points.end(), back.rbegin(), back.rend());
  return points;
}

// Signs at points that are not nearer to the curve than a part of its size.
void compare_beyond(double margin, const CurvedContour& contour, RandomPolygons& random,
                    int points) {
  const RegionEvaluator region(curved_polygon({contour}).region);
  const std::vector<Point> on = traced(contour, 25);
  const Box extent = extent_of(on);
  const Point &low = extent.low, &high = extent.high;
  const double size = std::max(high[0] - low[0], high[1] - low[1]);
  for (int i = 0; i < points; ++i) {
    Point at{random.real(low[0], high[0]), random.real(low[1], high[1])};
    if (i % 2 == 0) {
      const Point& near = on[random.integer(0, static_cast<int>(on.size()) - 1)];
      const double step = size * std::pow(10, random.real(-8, -1));
      at = {near[0] + random.real(-step, step), near[1] + random.real(-step, step)};
    }
    if (distance_from(contour, at) < margin * size) continue;
    ASSERT_EQ(region.contains(at), is_inside(contour, at)) << at[0] << ", " << at[1];
  }
}

// Curves nearer to their chords than 1e-9 of the size are straight.
constexpr double flat = 2e-9;

enum class Smooth { airfoil, snake };

// Curves that cross themselves or turn back are passed over.
void expect_smooth_contours(Smooth kind, double margin, double most_refused, int seed, int count) {
  RandomPolygons random(seed);
  int compared = 0, refused = 0;
  for (int i = 0; i < count; ++i) {
    const double unit = std::pow(10, -random.integer(3, 12));
    std::vector<Point> points;
    if (kind == Smooth::airfoil)
      points = airfoil(random.integer(8, 50), random.real(0.05, 0.2), unit);
    else
      points = snake(random, unit);
    CurvedContour contour;
    try {
      contour = of_spline(points);
    } catch (const InvalidArgument&) {
      continue;
    }
    if (crosses_itself(contour, 50)) continue;
    ++compared;
    try {
      compare_beyond(margin, contour, random, 200);
    } catch (const InvalidArgument& error) {
      ++refused;
      EXPECT_THAT(error.what(), testing::Not(HasSubstr("_arc")));
    }
    if (testing::Test::HasFatalFailure()) FAIL() << "contour " << i << " rounded to " << unit;
  }
  EXPECT_GT(compared, 0.6 * count);
  EXPECT_LE(refused, most_refused * count);
}

TEST(CurvedPolygons, OfSplinesWithInflectionsAtNarrowPlacesKeepTheirInside) {
  expect_smooth_contours(Smooth::airfoil, flat, 0.01, 31, 12);
  expect_smooth_contours(Smooth::snake, flat, 0.01, 32, 12);
}
TEST(LongCurvedPolygons, OfSplinesWithInflectionsAtNarrowPlacesKeepTheirInside) {
  expect_smooth_contours(Smooth::airfoil, flat, 0.01, 33, 500);
  expect_smooth_contours(Smooth::snake, flat, 0.01, 34, 500);
}

double least_step(const std::vector<Point>& points) {
  double least = INFINITY;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Point &p = points[i], &q = points[(i + 1) % points.size()];
    least = std::min(least, std::hypot(q[0] - p[0], q[1] - p[1]));
  }
  return least;
}

// Outlines of lines and arcs, points of which were written with some digits: between decimal ones
// splines take lines for what they are; between others they wind about them, by down to 1e-12 of
// the size. Every one is built.
void expect_rounded_outlines(double unit_factor, int seed, int count) {
  RandomPolygons random(seed);
  for (int i = 0; i < count; ++i) {
    const auto [points, unit] = rounded_outline(random, unit_factor);
    if (least_step(points) < 4 * unit) continue;  // rounding may turn the points back
    const CurvedContour contour = of_spline(points);
    if (crosses_itself(contour, 50)) continue;
    for (const Point& p : points) ASSERT_LE(distance_from(contour, p), 1.5 * unit);
    ASSERT_NO_THROW(compare_beyond(flat, contour, random, 200));
    if (testing::Test::HasFatalFailure()) FAIL() << "outline " << i << " rounded to " << unit;
  }
}

TEST(CurvedPolygons, OfSplinesThroughRoundedPointsOfLinesAndArcsAreRight) {
  expect_rounded_outlines(1, 35, 30);
  expect_rounded_outlines(std::numbers::pi, 36, 30);
}
TEST(LongCurvedPolygons, OfSplinesThroughRoundedPointsOfLinesAndArcsAreRight) {
  expect_rounded_outlines(1, 37, 1000);
  expect_rounded_outlines(std::numbers::pi, 38, 1000);
}

TEST(CurvedPolygons, OfAirfoilsKeepTheirInside) {
  RandomPolygons random(33);
  for (const int count : {15, 25, 35, 50})
    for (const double thickness : {0.09, 0.12, 0.18})
      for (const double unit : {1e-4, 1e-6, 1e-12}) {
        compare_beyond(flat, of_spline(airfoil(count, thickness, unit)), random, 50);
        if (testing::Test::HasFatalFailure()) FAIL() << count << " " << thickness << " " << unit;
      }
}

TEST(CurvedPolygons, EdgesThatAreAlmostStraightAreThere) {
  RandomPolygons random(34);
  for (int power = -16; power <= -1; ++power)
    for (const double sign : {1.0, -1.0}) {
      const double bulge = sign * std::pow(10, power);
      const CurvedContour square{{{0, 0}, {1, 0}, {1, 1}, {0, 1}}, {{bulge}, {}, {}, {}}};
      const Region region = curved_polygon({square}).region;
      compare_beyond(flat, square, random, 100);
      // The extreme of the arc is not taken for its chord.
      const Box box = bounding_box(RegionEvaluator(region));
      EXPECT_NEAR(box.low[1], std::min(0.0, -bulge / 2), 1e-9 + 1e-12) << bulge;
      if (std::fabs(bulge) > 2.1e-9) {
        EXPECT_NEAR(box.low[1], std::min(0.0, -bulge / 2), 1e-12) << bulge;
      }
      if (testing::Test::HasFatalFailure()) FAIL() << bulge;
    }
}

}  // namespace
}  // namespace rfm
