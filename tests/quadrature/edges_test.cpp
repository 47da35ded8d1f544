#include "quadrature/edges.hpp"

#include <gmock/gmock.h>

#include "core/error.hpp"
#include "core/point_algebra.hpp"
#include "core/primitives.hpp"
#include "quadrature/gauss_legendre.hpp"
#include "tests/quadrature/standard_regions.hpp"

using namespace rfm;
using namespace rfm::test;

namespace {

EdgeRule edges_of(const Region& region, const Box& box, const EdgeOptions& options = {}) {
  return make_edge_rule(RegionEvaluator(region), box, options);
}

void expect_certified(const EdgeRule& rule) {
  EXPECT_EQ(rule.report.uncertified_boxes, 0);
  EXPECT_EQ(rule.report.contact_boxes, 0);
  for (const double weight : rule.points.weights) EXPECT_GT(weight, 0);
}

Region napkin_ring() { return sphere({0, 0, 0}, 1) - cylinder({0, 0, 0}, {0, 0, 1}, 0.6); }

TEST(Edges, ACubeHasTwelveStraightEdgesOfRightAngles) {
  for (const Region& cube :
       {box({-0.85, -0.85, -0.85}, {0.85, 0.85, 0.85}, 3), rotated_cube(0.85)}) {
    const EdgeRule rule = edges_of(cube, cube_box(1.7, 3), {3, 8});
    expect_certified(rule);
    EXPECT_NEAR(rule.points.length(), 12 * 1.7, 1e-13);
    int pairs = 0;
    for (int i = 0; i < 6; ++i)
      for (int j = i + 1; j < 6; ++j) {
        const double length = rule.points.length(i, j);
        if (length == 0) continue;
        ++pairs;
        EXPECT_NEAR(length, 1.7, 1e-14);
      }
    EXPECT_EQ(pairs, 12);
    for (const double angle : rule.points.angles) EXPECT_NEAR(angle, pi / 2, 1e-13);
  }
}

TEST(Edges, ANapkinRingHasTwoCirclesOfEqualAngles) {
  const EdgeRule rule = edges_of(napkin_ring(), cube_box(1, 3), {8, 8});
  expect_certified(rule);
  EXPECT_NEAR(rule.points.length(), 2 * 2 * pi * 0.6, 1e-13);
  // Between the sphere, inside, and the cylinder, outside: the normals make acos(0.6).
  for (int i = 0; i < rule.points.size(); ++i) {
    const Point p = rule.points.point(i), t = rule.points.tangent(i);
    EXPECT_NEAR(rule.points.angles[i], std::acos(0.6), 1e-13);
    EXPECT_NEAR(std::hypot(p[0], p[1]), 0.6, 2e-16);
    EXPECT_NEAR(std::fabs(p[2]), 0.8, 4e-16);
    EXPECT_NEAR(dot(t, p), 0, 1e-15);
    EXPECT_NEAR(norm(t), 1, 1e-15);
  }
}

// Of a quarter of both circles, which no symmetry makes better than it is.
double error_of_arcs(int cells, int points) {
  const Region quarter =
      napkin_ring() & half_space({0, 0, 0}, {1, 0, 0}) & half_space({0, 0, 0}, {0, 1, 0});
  const EdgeRule rule = edges_of(quarter, cube_box(1, 3), {points, cells, INFINITY});
  return std::fabs(rule.points.length(0, 1) - 0.6 * pi);
}

TEST(Edges, ErrorsFallByTwiceAsManyPowersAsThereArePoints) {
  // The circles lie at other places of the boxes on every grid: orders are means over many.
  for (const int points : {1, 2, 3}) {
    double coarse = 0, fine = 0;
    for (int k = 0; k < 8; ++k) {
      coarse += error_of_arcs(24 + k, points);
      fine += error_of_arcs(96 + 4 * k, points);
    }
    const double order = std::log2(coarse / fine) / 2;
    EXPECT_GT(order, 2 * points - 0.3) << points;
    EXPECT_LT(order, 2 * points + 0.8) << points;
  }
}

TEST(Edges, AnObliqueCutOfACylinderIsAnEllipse) {
  // Half axes r and r / cos α; perimeter 4 a E(e).
  const double r = 0.7, alpha = 0.6;
  const Region cut = cylinder({0, 0, 0}, {0, 0, 1}, r) &
                     half_space({0, 0, 0.2}, {std::sin(alpha), 0, -std::cos(alpha)}) &
                     half_space({0, 0, -1.4}, {0, 0, 1});
  const EdgeRule rule = edges_of(cut, cube_box(1.5, 3), {10, 12});
  expect_certified(rule);
  const double a = r / std::cos(alpha), e = std::sqrt(1 - r * r / (a * a));
  EXPECT_NEAR(rule.points.length(0, 1), 4 * a * std::comp_ellint_2(e), 1e-13);
  EXPECT_NEAR(rule.points.length(0, 2), 2 * pi * r, 1e-13);
  EXPECT_EQ(rule.points.length(1, 2), 0);
}

TEST(Edges, CylindersOfDifferentRadiiMeetInTwoCurves) {
  // x² + y² = a², x² + z² = 1 with a < 1: the curves (a cos t, a sin t, ±√(1 − a² cos² t)). Their
  // length by the trapezoidal rule, which is exact to rounding for periodic functions.
  const double a = 0.8;
  double length = 0;
  constexpr int count = 2000;
  for (int i = 0; i < count; ++i) {
    const double t = 2 * pi * i / count, c = std::cos(t), s = std::sin(t);
    const double z = std::sqrt(1 - a * a * c * c), dz = a * a * c * s / z;
    length += 2 * std::sqrt(a * a + dz * dz) * 2 * pi / count;
  }
  const Region tee = (cylinder({0, 0, 0}, {0, 0, 1}, a) | cylinder({0, 0, 0}, {0, 1, 0}, 1)) &
                     box({-3, -2, -2}, {3, 2, 2}, 3);
  const EdgeRule rule = edges_of(tee, {3, {-1, -2, -2}, {1, 2, 2}}, {8, 24});
  expect_certified(rule);
  EXPECT_NEAR(rule.points.length(0, 1), length, 1e-12 * length);
  for (int i = 0; i < rule.points.size(); ++i) {
    if (rule.points.first[i] == 0 && rule.points.second[i] == 1) {
      EXPECT_GT(rule.points.angles[i], pi);
    }
  }
}

TEST(Edges, SteinmetzCylindersMeetInTwoEllipsesThatCross) {
  // x² + y² = 1, x² + z² = 1: ellipses y = ±z with half axes 1 and √2. At (±1, 0, 0) the cylinders
  // touch, which leaves small boxes that are not certified.
  const Region body = cylinder({0, 0, 0}, {0, 0, 1}, 1) & cylinder({0, 0, 0}, {0, 1, 0}, 1);
  const double length = 2 * 4 * std::sqrt(2) * std::comp_ellint_2(std::sqrt(0.5));
  for (const int cells : {3, 16}) {
    const EdgeRule rule = edges_of(body, cube_box(1, 3), {10, cells});
    EXPECT_GT(rule.report.uncertified_boxes, 0) << cells;
    EXPECT_LT(rule.report.uncertified_length, 0.01) << cells;
    EXPECT_NEAR(rule.points.length(), length, rule.report.uncertified_length + 1e-9) << cells;
  }
}

TEST(Edges, ThreePlanesThroughOneLineAreOneEdge) {
  const Region wedge = solid(y()) & solid(std::sin(1.0) * x() - std::cos(1.0) * y()) &
                       solid(std::sin(0.5) * x() + std::cos(0.5) * y()) &
                       box({-3, -3, -1}, {1, 3, 1}, 3);
  const EdgeRule rule = edges_of(wedge, cube_box(1.9, 3), {4, 6});
  EXPECT_EQ(rule.report.uncertified_boxes, 0);
  double axis = 0;
  for (int i = 0; i < rule.points.size(); ++i)
    if (std::hypot(rule.points.coordinates[0][i], rule.points.coordinates[1][i]) < 1e-12) {
      axis += rule.points.weights[i];
      EXPECT_NEAR(rule.points.angles[i], 1, 1e-13);
    }
  EXPECT_NEAR(axis, 2, 1e-13);
}

TEST(Edges, BoxesThatShareAFaceHaveTheEdgesOfTheirUnion) {
  const Region whole = box({-1, -1, -1}, {0, 1, 1}, 3) | box({0, -1, -1}, {1, 1, 1}, 3);
  EdgeRule rule = edges_of(whole, cube_box(1, 3), {2, 4});
  expect_certified(rule);
  EXPECT_NEAR(rule.points.length(), 24, 1e-13);
  // A step half as high: four edges more of length 2 and the corners' posts.
  const Region step = box({-1, -1, -1}, {0, 1, 1}, 3) | box({0, -1, -1}, {1, 1, 0}, 3);
  rule = edges_of(step, cube_box(1, 3), {2, 4});
  expect_certified(rule);
  // Along y: 6 of 2; the two L-shaped ends have perimeter 8 each.
  EXPECT_NEAR(rule.points.length(), 12 + 16, 1e-13);
  double reentrant = 0;
  for (int i = 0; i < rule.points.size(); ++i)
    if (rule.points.angles[i] > pi) reentrant += rule.points.weights[i];
  EXPECT_NEAR(reentrant, 2, 1e-13);
}

TEST(Edges, AFilletTouchesWithoutAnEdge) {
  // A bar with a rounded top: the plane sides touch the cylinder.
  const Region bar = cylinder({0, 0, 0}, {0, 1, 0}, 0.5) | box({-0.5, -2, -1}, {0.5, 2, 0}, 3);
  const Region finite = bar & box({-2, -1, -2}, {2, 1, 2}, 3);
  const EdgeRule rule = edges_of(finite, {3, {-0.5, -1, -1}, {0.5, 1, 0.5}}, {6, 16});
  EXPECT_GT(rule.report.contact_boxes, 0);
  EXPECT_EQ(rule.report.uncertified_boxes, 0);
  // Two along y, at the bottom; two ends of a half circle and three straight sides.
  EXPECT_NEAR(rule.points.length(), 2 * 2 + 2 * (0.5 * pi + 3), 1e-2);
}

// The perimeter of an ellipse by the trapezoidal rule, which converges geometrically.
double perimeter(double a, double b) {
  const int n = 2000;
  double sum = 0;
  for (int i = 0; i < n; ++i)
    sum += std::hypot(a * std::sin(2 * pi * i / n), b * std::cos(2 * pi * i / n)) * 2 * pi / n;
  return sum;
}

TEST(Edges, OfHolesThatAreSmallBesideTheBodyAreFound) {
  const double slant = std::sqrt(1.13);
  for (const double r : {5.0, 1.0, 0.1, 0.01, 1e-3}) {
    // Beyond ten thousand times smaller not all is resolved, which is told.
    const bool certified = r > 1e-2 - 1e-9;
    const Region block = box({0, 0, 0}, {100, 100, 100}, 3) -
                         cylinder({33.3, 47.7, 50}, {0, 0, 1}, r) -
                         cylinder({71.3, 17.7, 50}, {0.3, 0.2, 1}, r);
    const EdgeRule rule = edges_of(block, {3, {0, 0, 0}, {100, 100, 100}});
    EXPECT_EQ(rule.report.uncertified_boxes == 0, certified) << r;
    EXPECT_NEAR(rule.points.length(), 1200 + 4 * pi * r + 2 * perimeter(slant * r, r),
                1e-8 + rule.report.uncertified_length)
        << r;
    EXPECT_LT(rule.report.order_difference, 1e-7) << r;
  }
}

TEST(Edges, OrdersDifferByMoreThanTheErrorWhereBoxesAreCoarse) {
  for (const double r : {0.9, 1.1, 1.3})
    for (const int cells : {2, 3, 4, 6}) {
      const Region block = box({-2, -2, -2}, {2, 2, 2}, 3) - cylinder({0.1, 0.05, 0}, {0, 0, 1}, r);
      const EdgeRule rule = edges_of(block, cube_box(2, 3), {6, cells, INFINITY});
      EXPECT_LE(std::fabs(rule.points.length() - 48 - 4 * pi * r),
                rule.report.order_difference + 1e-12);
      EXPECT_LT(rule.report.order_difference, 1e-2);
      // Parts are divided until they agree.
      const EdgeRule fine = edges_of(block, cube_box(2, 3), {6, cells});
      EXPECT_NEAR(fine.points.length(), 48 + 4 * pi * r, 1e-10);
    }
}

TEST(Edges, WhatIsNoBodyIsRefused) {
  const RegionEvaluator plane(disk(0, 0, 1)), space(sphere({0, 0, 0}, 1));
  EXPECT_THROW(make_edge_rule(plane, cube_box(1, 2)), InvalidArgument);
  EXPECT_THROW(make_edge_rule(space, cube_box(1, 3), {0, 8}), InvalidArgument);
  EXPECT_THROW(make_edge_rule(space, cube_box(1, 3), {4, 0}), InvalidArgument);
  EXPECT_EQ(make_edge_rule(space, cube_box(1, 3)).points.size(), 0);
}

}  // namespace
