#include "core/curved_polygon.hpp"

#include <gmock/gmock.h>

#include <array>
#include <cmath>
#include <numbers>

#include "core/contour.hpp"
#include "core/error.hpp"
#include "core/evaluate.hpp"
#include "core/r_functions.hpp"
#include "core/tape.hpp"
#include "tests/core/random_polygons.hpp"

namespace rfm {
namespace {

using testing::HasSubstr;
constexpr double pi = std::numbers::pi;

// Points of a contour, `count` on each curved edge.
std::vector<Point> traced(const CurvedContour& contour, int count) {
  std::vector<Point> points;
  const std::size_t size = contour.points.size();
  for (std::size_t i = 0; i < size; ++i) {
    const Point &p = contour.points[i], &q = contour.points[(i + 1) % size];
    const EdgeCurve& edge = contour.edges[i];
    for (int k = 0; k < count; ++k) {
      const double t = static_cast<double>(k) / count;
      if (edge.conic) {
        const double a = (1 - t) * (1 - t), b = 2 * t * (1 - t) * edge.conic->weight, c = t * t;
        const Point& r = edge.conic->control;
        points.push_back({(a * p[0] + b * r[0] + c * q[0]) / (a + b + c),
                          (a * p[1] + b * r[1] + c * q[1]) / (a + b + c)});
      } else if (edge.bulge != 0) {
        // p + (q − p) sin(2 θ t) / sin(2 θ) turned by θ (2 t − 2) + … : in complex numbers, the
        // chord seen under the half angle.
        const double half = 2 * std::atan(edge.bulge), s = std::sin(half * t) / std::sin(half);
        const double turn = -half * (1 - t), c = std::cos(turn), d = std::sin(turn);
        const double x = q[0] - p[0], y = q[1] - p[1];
        points.push_back({p[0] + s * (c * x - d * y), p[1] + s * (d * x + c * y)});
      } else if (k == 0) {
        points.push_back(p);
      }
    }
  }
  return points;
}

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

bool crosses_itself(const CurvedContour& contour, int count) {
  const std::vector<Point> fine = traced(contour, count);
  std::vector<Segment> segments;
  std::vector<int> next;
  for (std::size_t i = 0; i < fine.size(); ++i) {
    segments.push_back({fine[i], fine[(i + 1) % fine.size()]});
    next.push_back(static_cast<int>((i + 1) % fine.size()));
  }
  return intersecting_pair(segments, next).has_value();
}

// Stars with edges of any curvature that leaves them simple, as far as 200 chords per edge show.
CurvedContour random_contour(RandomPolygons& random) {
  while (true) {
    CurvedContour contour;
    contour.points = random.next(RandomPolygons::Kind::star);
    if (contour.points.size() > 14) contour.points.resize(14);
    for (std::size_t i = 0; i < contour.points.size(); ++i)
      contour.edges.push_back({random.real(0, 1) < 0.3 ? 0 : random.real(-0.8, 0.8)});
    if (!crosses_itself(contour, 200)) return contour;
  }
}

// What is refused crosses itself beside a corner, closer than the generator can see.
void agree(int count) {
  RandomPolygons random(23);
  for (int i = 0; i < count; ++i) {
    const CurvedContour contour = random_contour(random);
    try {
      expect_right(contour, random, 200);
    } catch (const InvalidArgument& error) {
      EXPECT_TRUE(crosses_itself(contour, 20000)) << "contour " << i << ": " << error.what();
    }
    if (testing::Test::HasFatalFailure()) FAIL() << "contour " << i;
  }
}

TEST(CurvedPolygons, SignsAreThoseOfTheWindingNumber) { agree(40); }
TEST(LongCurvedPolygons, SignsAreThoseOfTheWindingNumber) { agree(1000); }

}  // namespace
}  // namespace rfm
