#include "core/bounding_box.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "core/error.hpp"
#include "core/polygon.hpp"
#include "core/primitives.hpp"
#include "core/profile_bodies.hpp"

namespace rfm {
namespace {

using testing::HasSubstr;
using testing::ThrowsMessage;

constexpr double pi = std::numbers::pi;
const Field x = x_coordinate(), y = y_coordinate(), z = z_coordinate();

Box bounds_of(const Region& region) { return bounding_box(RegionEvaluator(region)); }

// All sides within `tolerance` of those expected.
void expect_box(const Region& region, const Point& low, const Point& high, double tolerance) {
  const Box box = bounds_of(region);
  ASSERT_EQ(box.dimension, region.dimension());
  for (int axis = 0; axis < box.dimension; ++axis) {
    EXPECT_NEAR(box.low[axis], low[axis], tolerance) << "low side of axis " << axis;
    EXPECT_NEAR(box.high[axis], high[axis], tolerance) << "high side of axis " << axis;
  }
}

Region turned_square(double half, double angle, const Point& center) {
  const auto side = [&](double t) {
    return half_plane({center[0] + half * std::cos(t), center[1] + half * std::sin(t)},
                      {-std::cos(t), -std::sin(t)});
  };
  return side(angle) & side(angle + pi / 2) & side(angle + pi) & side(angle - pi / 2);
}

TEST(BoundingBox, OfADisk) { expect_box(circle({0.3, -0.2}, 0.7), {-0.4, -0.9}, {1, 0.5}, 2e-12); }

TEST(BoundingBox, OfARingIsThatOfItsOuterCircle) {
  expect_box(circle({0, 0}, 1) - circle({0.1, 0.2}, 0.4), {-1, -1}, {1, 1}, 3e-12);
}

TEST(BoundingBox, OfATurnedEllipse) {
  // The extreme of x over (a cos t, b sin t) turned by φ is √(a² cos²φ + b² sin²φ).
  const double a = 1.5, b = 0.4, angle = 0.6, c = std::cos(angle), s = std::sin(angle);
  const double width = std::hypot(a * c, b * s), height = std::hypot(a * s, b * c);
  expect_box(ellipse({0.3, -0.2}, {a, b}, angle), {0.3 - width, -0.2 - height},
             {0.3 + width, -0.2 + height}, 5e-12);
}

TEST(BoundingBox, SidesOfABoxAreExact) {
  const Box unit = bounds_of(box({0, 0}, {1, 1}));
  EXPECT_EQ(unit.low, (Point{0, 0}));
  EXPECT_EQ(unit.high, (Point{1, 1}));
  const Box plate = bounds_of(box({-0.1, 0.3}, {2.7, 0.9}) - circle({1, 0.6}, 0.2));
  EXPECT_EQ(plate.low, (Point{-0.1, 0.3}));
  EXPECT_EQ(plate.high, (Point{2.7, 0.9}));
  const Box brick = bounds_of(box({0, -1, 0.2}, {0.1, 1, 7}, 3));
  EXPECT_EQ(brick.low, (Point{0, -1, 0.2}));
  EXPECT_EQ(brick.high, (Point{0.1, 1, 7}));
  const Box interval = bounds_of(box({-0.3}, {0.7}, 1));
  EXPECT_EQ(interval.low[0], -0.3);
  EXPECT_EQ(interval.high[0], 0.7);
}

TEST(BoundingBox, CornersOfATurnedSquareAreExactToRounding) {
  for (const double angle : {0.1, 0.5, pi / 4, 1.3}) {
    const double reach = 0.5 * (std::fabs(std::cos(angle)) + std::fabs(std::sin(angle)));
    expect_box(turned_square(0.5, angle, {0, 0}), {-reach, -reach}, {reach, reach}, 1e-15);
    expect_box(turned_square(0.5, angle, {3, -2}), {3 - reach, -2 - reach}, {3 + reach, -2 + reach},
               4e-15);
  }
}

TEST(BoundingBox, CornersOfATurnedCubeAreExactToRounding) {
  // The unit cube with its diagonal along z: |u·p| ≤ 1/2 for three orthogonal directions.
  std::vector<Region> sides;
  const double third = 2 * pi / 3;
  for (int k = 0; k < 3; ++k) {
    const Field along = std::sqrt(2.0 / 3) * (std::cos(k * third) * x + std::sin(k * third) * y) +
                        std::sqrt(1.0 / 3) * z;
    sides.push_back(level_set(0.5 - along, 3));
    sides.push_back(level_set(0.5 + along, 3));
  }
  Region cube = sides[0];
  for (int k = 1; k < 6; ++k) cube = cube & sides[k];
  const Box box = bounds_of(cube);
  EXPECT_NEAR(box.high[2], 0.5 * std::sqrt(3), 1e-14);
  EXPECT_NEAR(box.low[2], -0.5 * std::sqrt(3), 1e-14);
  EXPECT_NEAR(box.high[0], std::sqrt(2.0 / 3), 1e-14);  // ½ √(2/3) (1 + ½ + ½)
  EXPECT_NEAR(box.high[1], std::sqrt(0.5), 1e-14);      // a whole edge, ½ √(2/3) √3
}

TEST(BoundingBox, OfALens) {
  // Two unit circles at distance 1: corners at (½, ±√3/2), sides where the circles are vertical.
  expect_box(circle({0, 0}, 1) & circle({1, 0}, 1), {0, -std::sqrt(0.75)}, {1, std::sqrt(0.75)},
             1e-12);
}

TEST(BoundingBox, OfAUnionOfDistantParts) {
  expect_box(circle({-20, 3}, 0.5) | circle({30, -7}, 0.1), {-20.5, -7.1}, {30.1, 3.5}, 1e-10);
}

TEST(BoundingBox, OfTinyRegionsFarAway) {
  const double radius = 1e-4;
  const Box box = bounds_of(circle({1000, -500}, radius));
  EXPECT_NEAR(box.low[0], 1000 - radius, 3e-12);  // a few roundings of the coordinate
  EXPECT_NEAR(box.high[1], -500 + radius, 3e-12);
}

TEST(BoundingBox, OfALargeRegion) {
  expect_box(circle({2e6, 0}, 3e6), {-1e6, -3e6}, {5e6, 3e6}, 1e-5);
}

TEST(BoundingBox, OfABall) {
  expect_box(level_set(4 - x * x - y * y - pow(z - 1, 2), 3), {-2, -2, -1}, {2, 2, 3}, 1e-11);
}

TEST(BoundingBox, OfACylinderIsRightToRoundingAtItsEdges) {
  // A disk of radius r across the unit vector a extends by r √(1 − a_i²) along axis i.
  const Box box = bounds_of(cylinder({0.1, -0.05, 0.02}, {1, 2, 2}, 0.5, 1.2));
  const Point center{0.1, -0.05, 0.02}, a{1.0 / 3, 2.0 / 3, 2.0 / 3};
  for (int axis = 0; axis < 3; ++axis) {
    const double extent = 0.6 * a[axis] + 0.5 * std::sqrt(1 - a[axis] * a[axis]);
    EXPECT_NEAR(box.low[axis], center[axis] - extent, 2e-12);
    EXPECT_NEAR(box.high[axis], center[axis] + extent, 2e-12);
    EXPECT_LE(box.low[axis], center[axis] - extent + 2e-16);  // from outside, to rounding
    EXPECT_GE(box.high[axis], center[axis] + extent - 2e-16);
  }
}

TEST(BoundingBox, OfAFunctionThatIsNotAPolynomial) {
  // y ≤ 1 + sin(3x)/10 over [0, 2] × [0, ∞): the highest point is at x = π/6.
  const Region roof = box({0, 0}, {2, 9}) & level_set(1 + 0.1 * sin(3 * x) - y);
  expect_box(roof, {0, 0}, {2, 1.1}, 1e-11);
}

TEST(BoundingBox, WeakBoundsOverLargeBoxesAreOvercome) {
  // A thin ellipse along the diagonal, (x + y)² + 100 (x − y)² ≤ 1 expanded, as a function whose
  // bounds do not see that it is one. The extreme of x on xᵀAx = 1 is √(A⁻¹)₁₁ = √(101 / 400).
  const Field q = 101 * x * x - 198 * x * y + 101 * y * y;
  const double reach = std::sqrt(101.0 / 400);
  expect_box(level_set(exp(-q) - std::exp(-1)), {-reach, -reach}, {reach, reach}, 1e-8);
}

TEST(BoundingBox, EveryPointOfTheRegionIsInside) {
  const RegionEvaluator region((circle({0, 0}, 1) - half_plane({0.3, 0.1}, {1, 2})) |
                               ellipse({0.4, 0.4}, {0.9, 0.2}, 2.1));
  const Box box = bounding_box(region);
  for (double a = -1.5; a < 1.5; a += 0.013)
    for (double b = -1.5; b < 1.5; b += 0.013)
      EXPECT_TRUE(!region.contains(Point{a, b}) || box.contains({a, b})) << a << ", " << b;
}

// A box that is known beforehand only tells where to search.
TEST(BoundingBox, DoesNotDependOnHowMuchIsKnownBeforehand) {
  const Region lens = circle({0, 0}, 1) & circle({1.2, 0.3}, 0.9);
  const Box searched = bounding_box(RegionEvaluator(lens));
  for (const double margin : {0.0, 0.1, 30.0}) {
    Box known = searched;
    for (int axis = 0; axis < 2; ++axis) known.low[axis] -= margin, known.high[axis] += 2 * margin;
    const Box found = bounding_box(RegionEvaluator(lens.within(known)));
    for (int axis = 0; axis < 2; ++axis) {
      EXPECT_NEAR(found.low[axis], searched.low[axis], 1e-11 * (1 + margin));
      EXPECT_NEAR(found.high[axis], searched.high[axis], 1e-11 * (1 + margin));
    }
  }
}

TEST(BoundingBox, OfAPolygonOfManyEdgesIsThatOfItsPoints) {
  constexpr int edges = 1000;  // a search from afar calls this one unbounded
  std::vector<Point> points;
  Box box{2, {1, 1}, {-1, -1}};
  for (int k = 0; k < edges; ++k) {
    const double radius = k % 2 == 0 ? 1 : 0.6, angle = 2 * std::numbers::pi * (k + 0.3) / edges;
    points.push_back({radius * std::cos(angle), radius * std::sin(angle)});
    for (int axis = 0; axis < 2; ++axis) {
      box.low[axis] = std::min(box.low[axis], points.back()[axis]);
      box.high[axis] = std::max(box.high[axis], points.back()[axis]);
    }
  }
  expect_box(polygon(points), box.low, box.high, 1e-12);
  // Cut in half, its known box is too large. (The cut leaves out the highest point.)
  box.low = {0, 1}, box.high = {1, -1};
  for (const Point& point : points)
    if (point[0] > 0)
      box.low[1] = std::min(box.low[1], point[1]), box.high[1] = std::max(box.high[1], point[1]);
  box.high[0] = std::ranges::max(points, {}, [](const Point& p) { return p[0]; })[0];
  expect_box(polygon(points) & half_plane({0, 0}, {1, 0}), box.low, box.high, 1e-12);
}

TEST(BoundingBox, ThatShapesKnowIsTheOneThatASearchFinds) {
  const Point c{0.3, -0.2, 0.4}, axis{1, 2, -0.5};
  const std::vector<Region> shapes{circle({0.3, -0.2}, 0.7),
                                   ellipse({0.3, -0.2}, {1.5, 0.4}, 0.6),
                                   box({-1, 0.2}, {0.7, 0.9}),
                                   sector({0.3, -0.2}, 1.2, 0.3, 2.1),
                                   sector({0.3, -0.2}, 1.2, -0.4, 1.1, 0.5),
                                   sector({0.3, -0.2}, 1.2, 2.0, 6.5, 0.5),
                                   sphere(c, 0.7),
                                   ellipsoid(c, {1.2, 0.4, 0.7}, axis, 0.8),
                                   box({-1, 0.2, 0}, {0.7, 0.9, 2}, 3),
                                   cylinder(c, axis, 0.3, 1.4),
                                   cone(c, axis, 0.4, 1.4),
                                   torus(c, axis, 1, 0.3),
                                   capsule(c, {1, 1, 1}, 0.3)};
  for (const Region& shape : shapes) {
    ASSERT_TRUE(shape.enclosure());
    const Box known = *shape.enclosure();
    // By an expression that is not known to lie in a box.
    const Box found = bounds_of(shape.with_expression(shape.expression()));
    for (int axis_number = 0; axis_number < known.dimension; ++axis_number) {
      EXPECT_NEAR(known.low[axis_number], found.low[axis_number], 2e-6);
      EXPECT_NEAR(known.high[axis_number], found.high[axis_number], 2e-6);
    }
  }
  EXPECT_FALSE(cylinder(c, axis, 0.3).enclosure());
  EXPECT_FALSE(strip({0, 0}, {1, 0}, 1).enclosure());
}

TEST(BoundingBox, OfPartsThatAreKnownToLieApartIsRefusedAsEmpty) {
  const Region a = circle({0, 0}, 1).within({2, {-1, -1}, {1, 1}});
  const Region b = circle({5, 0}, 1).within({2, {4, -1}, {6, 1}});
  EXPECT_THROW(bounding_box(RegionEvaluator(a & b)), InvalidArgument);
}

TEST(BoundingBox, UnboundedRegionsAreRefusedWithTheirDirection) {
  EXPECT_THAT(
      [] {
        bounds_of(half_plane({0, 0}, {1, 0}));
      },
      ThrowsMessage<InvalidArgument>(HasSubstr("not bounded in the direction +x")));
  EXPECT_THAT(
      [] {
        bounds_of(half_plane({0, 0}, {0, -1}) & half_plane({0, 0}, {1, 0}) &
                  half_plane({1, 0}, {-1, 0}));
      },
      ThrowsMessage<InvalidArgument>(HasSubstr("not bounded in the direction -y")));
  EXPECT_THROW(bounds_of(!circle({0, 0}, 1)), InvalidArgument);
}

TEST(BoundingBox, EmptyRegionsAreRefused) {
  EXPECT_THAT(
      [] {
        bounds_of(circle({0, 0}, 1) & circle({5, 0}, 1));
      },
      ThrowsMessage<InvalidArgument>(HasSubstr("empty")));
  EXPECT_THAT([] { bounds_of(level_set(-1 - x * x)); },
              ThrowsMessage<InvalidArgument>(HasSubstr("empty")));
}

TEST(BoundingBox, OfTurnedProfilesIsExact) {
  expect_box(revolution(box({0, 0}, {1, 1})), {-1, -1, 0}, {1, 1, 1}, 1e-14);
  expect_box(revolution(circle({0.2, 0}, 0.4)), {-0.6, -0.6, -0.4}, {0.6, 0.6, 0.4}, 1e-12);
  expect_box(revolution(ellipse({0.5, 0}, {0.6, 0.3})), {-1.1, -1.1, -0.3}, {1.1, 1.1, 0.3}, 1e-12);
  // The widest part of the profile lies beyond the axis and does not count.
  const double top = std::sqrt(0.16 - 0.04);
  expect_box(revolution(circle({-0.2, 0}, 0.4)), {-0.2, -0.2, -top}, {0.2, 0.2, top}, 1e-12);
  // About an oblique axis: a torus knows its own box.
  const Point center{0.3, -0.2, 0.4}, axis{1, 2, -0.5};
  const Box ring = *torus(center, axis, 1, 0.3).enclosure();
  expect_box(revolution(circle({1, 0}, 0.3), center, axis), ring.low, ring.high, 1e-12);
  const Box can = *cylinder({0, 0, 0}, axis, 0.5, 2).enclosure();
  expect_box(revolution(box({0, -1}, {0.5, 1}), {0, 0, 0}, axis), can.low, can.high, 1e-12);
}

TEST(BoundingBox, TellsHowFarItMayLieBeyondTheRegion) {
  EXPECT_EQ(bounding_box_and_excess(RegionEvaluator(circle({0.3, 0}, 1))).excess, 0);
  // Of fourth degree and flat at its extremes, without a box of its own: the search ends early.
  const Region flat = level_set(1.0 - pow(x, 8.0) - pow(y, 8.0) - pow(z, 8.0), 3);
  const BoundingBox found = bounding_box_and_excess(RegionEvaluator(flat));
  for (int axis = 0; axis < 3; ++axis)
    for (const double beyond : {found.box.high[axis] - 1, -1 - found.box.low[axis]}) {
      EXPECT_GE(beyond, -1e-13);
      EXPECT_LE(beyond, found.excess + 1e-12);
    }
  EXPECT_LT(found.excess, 0.05);
  // The search ends early also along the circles where a torus is extreme; its box is known.
  EXPECT_LT(bounding_box_and_excess(RegionEvaluator(torus({0, 0, 0}, {0, 0, 1}, 1, 0.4))).excess,
            1e-12);
}

}  // namespace
}  // namespace rfm
