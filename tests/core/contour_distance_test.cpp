#include "core/contour_distance.hpp"

#include <gmock/gmock.h>

#include <cmath>

#include "core/error.hpp"
#include "core/evaluate.hpp"
#include "tests/core/random_contours.hpp"

namespace rfm {
namespace {

// The least of many points, and the least around it by golden section.
Real from_conic(const Point& p, const EdgeCurve::Conic& conic, const Point& q, const Point& x) {
  const auto square = [&](Real t) {
    const Real a = (1 - t) * (1 - t), b = 2 * t * (1 - t) * conic.weight, c = t * t;
    const Real w = a + b + c;
    return std::hypot((a * p[0] + b * conic.control[0] + c * q[0]) / w - x[0],
                      (a * p[1] + b * conic.control[1] + c * q[1]) / w - x[1]);
  };
  constexpr int count = 400;
  int best = 0;
  for (int i = 1; i <= count; ++i)
    if (square(Real(i) / count) < square(Real(best) / count)) best = i;
  Real low = std::max(Real(0), Real(best - 1) / count),
       high = std::min(Real(1), Real(best + 1) / count);
  const Real golden = (std::sqrt(Real(5)) - 1) / 2;
  for (int i = 0; i < 100; ++i) {
    const Real a = high - golden * (high - low), b = low + golden * (high - low);
    (square(a) < square(b) ? high : low) = square(a) < square(b) ? b : a;
  }
  return square((low + high) / 2);
}

double brute_force(const CurvedContour& contour, const Point& x) {
  Real least = INFINITY;
  const std::size_t count = contour.points.size();
  for (std::size_t i = 0; i < count; ++i)
    if (const auto& conic = contour.edges[i].conic)
      least = std::min(least,
                       from_conic(contour.points[i], *conic, contour.points[(i + 1) % count], x));
  return std::min(static_cast<double>(least), distance_from(contour, x));
}

// Values against brute force, signs against the winding number, and what is true of every
// distance: x − d∇d lies on the contour, and |∇d|² − 1 vanishes with its derivatives.
void expect_distance(const CurvedContour& contour, RandomPolygons& random, int points,
                     double tolerance) {
  const Field distance = contour_distance({contour});
  const Field slope = pow(partial(distance, 0), 2.0) + pow(partial(distance, 1), 2.0);
  const std::vector<Point> fine = traced(contour, 400);
  for (int i = 0; i < points; ++i) {
    const Point& near = fine[random.integer(0, static_cast<int>(fine.size()) - 1)];
    const double step = std::pow(10, random.real(-3, 0.5));
    const Point x{near[0] + random.real(-step, step), near[1] + random.real(-step, step)};
    const double expected = brute_force(contour, x), found = value_at(distance, x);
    ASSERT_NEAR(std::fabs(found), expected, tolerance) << "at " << x[0] << ", " << x[1];
    if (expected > 1e-3) {
      ASSERT_EQ(found > 0, winds_around(fine, x)) << "at " << x[0] << ", " << x[1];
    }
    const auto jet = evaluate(distance, x, 1);
    const double gx = jet.derivative(1, 0), gy = jet.derivative(0, 1);
    ASSERT_NEAR(std::hypot(gx, gy), 1, 1e-12) << "at " << x[0] << ", " << x[1];
    ASSERT_NEAR(brute_force(contour, {x[0] - found * gx, x[1] - found * gy}), 0, 4 * tolerance);
    const auto eikonal = evaluate(slope, x, 2);
    // A derivative is as large as the curvature of the level lines raised to its order.
    const double scale = std::pow(1 + 1 / expected, 3);
    for (const auto& [a, b] : {std::pair(1, 0), {0, 1}, {2, 0}, {1, 1}, {0, 2}})
      ASSERT_NEAR(eikonal.derivative(a, b) / scale, 0, 1e-9)
          << a << b << " at " << x[0] << ", " << x[1];
  }
}

CurvedContour straight(std::vector<Point> points) {
  CurvedContour contour{std::move(points), {}};
  contour.edges.resize(contour.points.size());
  return contour;
}

TEST(ContourDistance, OfPolygonsIsThatOfBruteForce) {
  RandomPolygons random(31);
  for (int i = 0; i < 100; ++i) {
    const auto kind =
        static_cast<RandomPolygons::Kind>(i % static_cast<int>(RandomPolygons::Kind::count));
    expect_distance(straight(random.next(kind)), random, 20, 2e-14);
    if (HasFatalFailure()) FAIL() << "polygon " << i;
  }
}

TEST(ContourDistance, OfArcsIsThatOfBruteForce) {
  RandomPolygons random(32);
  for (int i = 0; i < 30; ++i) {
    expect_distance(random_contour(random), random, 20, 2e-14);
    if (HasFatalFailure()) FAIL() << "contour " << i;
  }
  expect_distance({{{0, 0}, {1, 0}}, {{}, {2.5}}}, random, 100, 2e-15);      // beyond a semicircle
  expect_distance({{{0, 0}, {1, 0}}, {{-0.3}, {0.5}}}, random, 100, 2e-15);  // a crescent
  // Almost straight arcs, of radius 2,500: nothing is lost.
  expect_distance({{{0, 0}, {1, 0}, {0.5, 1}}, {{1e-4}, {-1e-4}, {1e-4}}}, random, 100, 2e-15);
}

TEST(ContourDistance, OfConicsIsThatOfBruteForce) {
  RandomPolygons random(33);
  for (const double weight : {0.3, std::sqrt(0.5), 1.0, 2.5})
    for (const double height : {-0.4, 1.5}) {
      CurvedContour contour{{{0, 0}, {2, 0}, {2, 1}, {0, 1}}, {{}, {}, {}, {}}};
      contour.edges[2].conic = EdgeCurve::Conic{{1.2, 1 + height}, weight};
      expect_distance(contour, random, 40, 1e-14);
      if (HasFatalFailure()) FAIL() << "weight " << weight << ", height " << height;
    }
}

TEST(ContourDistance, OfAStadiumIsThatOfItsSegment) {
  const Field distance =
      contour_distance({{{{0, 0}, {2, 0}, {2, 1}, {0, 1}}, {{}, {1.0}, {}, {1.0}}}});
  RandomPolygons random(34);
  for (int i = 0; i < 200; ++i) {
    const Point x{random.real(-2, 4), random.real(-2, 3)};
    EXPECT_NEAR(value_at(distance, x), 0.5 - distance_from({0, 0.5}, {2, 0.5}, x), 2e-15);
  }
}

TEST(ContourDistance, HolesAndIslandsAreToldByNesting) {
  // A box of side 6 with a hole of side 4 that runs the same way, and an island in it.
  const auto square = [](double half) {
    return straight({{-half, -half}, {half, -half}, {half, half}, {-half, half}});
  };
  const Field distance = contour_distance({square(3), square(2), square(1)});
  EXPECT_DOUBLE_EQ(value_at(distance, {0, 0.5}), 0.5);
  EXPECT_DOUBLE_EQ(value_at(distance, {0, 1.25}), -0.25);
  EXPECT_DOUBLE_EQ(value_at(distance, {0, 2.25}), 0.25);
  EXPECT_DOUBLE_EQ(value_at(distance, {4, 4}), -std::sqrt(2));
}

TEST(ContourDistance, BoundsHold) {
  RandomPolygons random(35);
  const CurvedContour contour = random_contour(random);
  const Field distance = contour_distance({contour});
  const auto& source = *distance.node().source;
  int smooth = 0;
  for (int i = 0; i < 300; ++i) {
    const double size = std::pow(10, random.real(-3, 0));
    Box box{2, {random.real(-1.5, 1.5), random.real(-1.5, 1.5)}, {}};
    for (int axis = 0; axis < 2; ++axis)
      box.high[axis] = box.low[axis] + size * random.real(0.1, 1);
    const FunctionBounds bounds = source.bounds(box);
    smooth += bounds.smooth ? 1 : 0;
    for (int k = 0; k < 20; ++k) {
      const Point x{random.real(box.low[0], box.high[0]), random.real(box.low[1], box.high[1])};
      EXPECT_TRUE(bounds.value.contains(value_at(distance, x)));
    }
  }
  EXPECT_GT(smooth, 30);
}

}  // namespace
}  // namespace rfm
