// Events in space that come in pairs, close together: an edge that a face cuts twice, surfaces that
// touch or nearly do. Each is found, or the report says where it may have been missed.

#include <gmock/gmock.h>
#include <tbb/global_control.h>

#include "quadrature/domain_rule.hpp"
#include "quadrature/work.hpp"
#include "tests/quadrature/standard_regions.hpp"

using namespace rfm;
using namespace rfm::test;

namespace {

DomainRule rule_for(const Region& region, const Grid& grid, int points) {
  QuadratureOptions options;
  options.inside_points = options.cut_points = points;
  return make_domain_rule(RegionEvaluator(region), grid, options);
}

// The drum x² + y² ≤ 1, |z| ≤ 0.3 without its part beyond x = 1 − depth. The face cuts the two
// round edges twice each, √(2 depth) apart.
struct ShavedDrum {
  explicit ShavedDrum(double depth)
      : region(solid(1 - square(x()) - square(y())) & solid(0.3 - z()) & solid(0.3 + z()) &
               solid(1 - depth - x())),
        half_angle(2 * std::asin(std::sqrt(depth / 2))) {}
  double base() const { return pi - half_angle + 0.5 * std::sin(2 * half_angle); }
  double volume() const { return 0.6 * base(); }
  double area() const {
    return 2 * base() + 0.6 * (2 * (pi - half_angle) + 2 * std::sin(half_angle));
  }
  Region region;
  double half_angle;
};

TEST(SpaceEvents, AnEdgeCutTwiceWithinACellIsCutTwice) {
  // At every depth the face shaves off a piece within one cell, at every position of it there.
  for (const double depth : {1e-2, 1e-3, 1e-4, 1e-6})
    for (int k = 0; k < 6; ++k) {
      const ShavedDrum drum(depth);
      Box box = cube_box(1.7, 3);
      for (int axis = 0; axis < 3; ++axis) {
        box.low[axis] += 0.01 * k * (axis + 1);
        box.high[axis] += 0.01 * k * (axis + 1);
      }
      const DomainRule rule = rule_for(drum.region, Grid(box, {7, 7, 7}), 12);
      EXPECT_NEAR(rule.measure(), drum.volume(), 1e-10) << depth << " " << k;
      EXPECT_NEAR(rule.boundary_measure(), drum.area(), 1e-8) << depth << " " << k;
      EXPECT_EQ(rule.report().uncertified.boxes, 0);
      EXPECT_EQ(rule.report().uncertified.contact_boxes, 0);
    }
}

TEST(SpaceEvents, TurnedEdgesCutTwiceToo) {
  // The same with every face askew, and the axes of the base plane not those of the drum.
  const auto rows = standard_rotation();
  const auto along = [&](int i) { return rows[i][0] * x() + rows[i][1] * y() + rows[i][2] * z(); };
  for (const double depth : {1e-2, 1e-4}) {
    const ShavedDrum drum(depth);
    const Region region = solid(1 - square(along(0)) - square(along(1))) & solid(0.3 - along(2)) &
                          solid(0.3 + along(2)) & solid(1 - depth - along(0));
    const DomainRule rule = rule_for(region, grid(1.7, 7, 3), 12);
    EXPECT_NEAR(rule.measure(), drum.volume(), 1e-10) << depth;
    EXPECT_NEAR(rule.boundary_measure(), drum.area(), 1e-8) << depth;
    EXPECT_EQ(rule.report().uncertified.boxes, 0);
  }
}

TEST(SpaceEvents, BallsThatOverlapByLittleAreNotTakenToTouch) {
  // Inside the unit ball, a ball of radius 1/2 that reaches beyond it by d. The cap of height h₁ of
  // the small ball outside and the boundary between follow from the circle where both meet.
  for (const double d : {1e-2, 1e-4, 1e-6}) {
    const double c = 0.5 + d;  // distance of the centres
    const double plane = (c * c + 1 - 0.25) / (2 * c);
    const double lens_small = 0.5 - (plane - c), lens_large = 1 - plane;
    // Part of the small ball beyond the plane, and of the large ball.
    const auto cap = [](double r, double h) { return pi * h * h * (r - h / 3); };
    const double small_beyond = cap(0.5, 0.5 - (plane - c)), large_beyond = cap(1, lens_large);
    const double common = 4 * pi / 3 * 0.125 - small_beyond + large_beyond;
    const double volume = 4 * pi / 3 - common;
    const double area = 4 * pi - 2 * pi * lens_large + pi - pi * lens_small;
    const Region region =
        solid(1 - square(x()) - square(y()) - square(z())) -
        solid(0.25 - square(x() - 0.48 * c) - square(y() - 0.64 * c) - square(z() - 0.6 * c));
    const DomainRule rule = rule_for(region, grid(1.7, 8, 3), 12);
    // The smallest circle is smaller than the smallest boxes: there the report says so, and the
    // boundary is wrong by no more than the sides of these boxes.
    const Uncertified& uncertified = rule.report().uncertified;
    const double box = uncertified.boxes > 0 ? uncertified.measure / uncertified.boxes : 0;
    EXPECT_NEAR(rule.measure(), volume, 1e-11 + uncertified.measure) << d;
    EXPECT_NEAR(rule.boundary_measure(), area, 1e-9 + uncertified.boxes * std::pow(box, 2.0 / 3))
        << d;
    EXPECT_LT(uncertified.measure, 1e-5) << d;
    if (d == 1e-2) {
      EXPECT_EQ(uncertified.boxes, 0);
    }
  }
}

TEST(SpaceEvents, ContactsAlongCurvesAreAcceptedAndCounted) {
  // The plane touches the torus along a circle and cuts nothing off.
  const Region torus =
      solid(0.16 - square(sqrt(square(x()) + square(y())) - 1) - square(z() - 0.02));
  const DomainRule rule = rule_for(torus & solid(0.42 - z()), grid(1.7, 8, 3), 6);
  EXPECT_EQ(rule.report().uncertified.boxes, 0);
  EXPECT_GT(rule.report().uncertified.contact_boxes, 0);
  EXPECT_NEAR(rule.measure(), 0.32 * pi * pi, 1e-6);
}

TEST(SpaceEvents, QuadricsThatTouchPlanesOfTheGridAlongALineAreProved) {
  // Grid planes at multiples of 1/4 in a box of ±1: a tilted rod that touches x = 1/2 and x = −1/2
  // along lines, and a cone that touches z = 0 along one.
  const Grid planes({3, {-1, -1, -1}, {1, 1, 1}}, {8, 8, 8});
  const double c = std::sqrt(0.5);
  const Field along = c * (y() - z()), across = c * (y() + z());
  const Region rod =
      solid(0.25 - square(x()) - square(across)) & solid(0.5 - along) & solid(0.5 + along);
  // The same rod as a bore, whose function is positive on those planes.
  const Region bore = solid(0.75 - x()) & solid(0.75 + x()) & solid(0.6 - across) &
                      solid(0.6 + across) & solid(0.5 - along) & solid(0.5 + along) &
                      solid(square(x()) + square(across) - 0.25);
  const Field axis = c * (x() + z()), square_of_distance = square(x()) + square(y()) + square(z());
  const Region cone =
      solid(square(axis) - 0.5 * square_of_distance) & solid(axis) & solid(0.5 - axis);
  // The apex of the cone is a node: its cells spend their budgets there, and nowhere else.
  struct Case {
    Region region;
    double volume, area, area_error, uncertified;
    std::int64_t work;
  };
  for (const auto& [region, volume, area, area_error, uncertified, work] :
       {Case{rod, 0.25 * pi, 1.5 * pi, 1e-8, 1e-15, 1'000'000},
        Case{bore, 1.8 - 0.25 * pi, 9 - 0.5 * pi + pi, 1e-8, 1e-15, 3'000'000},
        Case{cone, pi / 24, 0.25 * pi * (1 + std::sqrt(2.0)), 2e-6, 1e-3, 60'000'000}})
    for (const int points : {7, 8}) {
      const std::int64_t before = work_done;
      tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
      const DomainRule rule = rule_for(region, planes, points);
      EXPECT_NEAR(rule.measure(), volume, 1e-10);
      EXPECT_NEAR(rule.boundary_measure(), area, area_error);
      EXPECT_EQ(rule.report().uncertified.contact_boxes, 0);
      EXPECT_LT(rule.report().uncertified.measure, uncertified);
      EXPECT_LT(work_done - before, work);
    }
}

TEST(SpaceEvents, ATorusThatTouchesAPlaneOfTheGridAlongACircleIsNotTakenApart) {
  // Its top is the plane z = 1/4 of the grid.
  const Field ring = sqrt(square(x()) + square(y())) - 0.5;
  const Region torus = solid(0.0625 - square(ring) - square(z()));
  const DomainRule rule = rule_for(torus, Grid({3, {-1, -1, -1}, {1, 1, 1}}, {8, 8, 8}), 8);
  // Left open are boxes where the circle is parallel to a grid line in the plane, too.
  EXPECT_GT(rule.report().uncertified.contact_boxes, 0);
  EXPECT_LT(rule.report().uncertified.measure, 1e-5);
  EXPECT_NEAR(rule.measure(), 0.0625 * pi * pi, 1e-8);
  EXPECT_NEAR(rule.boundary_measure(), 0.5 * pi * pi, 1e-6);
}

TEST(SpaceEvents, SixPlanesThroughOneVertex) {
  // A hexagonal pyramid with its apex inside a cell: base of circumradius 1 at z = 0, height 1.2.
  const double height = 1.2, apothem = std::sqrt(0.75);
  Region pyramid = solid(z() + 0.011);
  for (int k = 0; k < 6; ++k) {
    const double t = 0.2 + k * pi / 3;
    pyramid = pyramid & solid(apothem * (height - z() - 0.011) / height -
                              std::cos(t) * (x() - 0.013) - std::sin(t) * (y() + 0.017));
  }
  const double base = 1.5 * std::sqrt(3.0);
  const double slant = std::hypot(apothem, height);
  for (const int cells : {3, 5, 8}) {
    const DomainRule rule = rule_for(pyramid, grid(1.7, cells, 3), 2);
    EXPECT_NEAR(rule.measure(), base * height / 3, 1e-13) << cells;
    EXPECT_NEAR(rule.boundary_measure(), base + 3 * slant, 1e-13) << cells;
    EXPECT_EQ(rule.report().uncertified.boxes, 0) << cells;
  }
}

}  // namespace
