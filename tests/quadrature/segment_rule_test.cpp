#include "quadrature/segment_rule.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "core/error.hpp"
#include "core/primitives.hpp"

using namespace rfm;

namespace {

template <class Integrand>
double integral(const VolumePoints& rule, const Integrand& f) {
  double sum = 0;
  for (int i = 0; i < rule.size(); ++i) sum += rule.weights[i] * f(rule.point(i));
  return sum;
}

const Point from{-2, -1, 0.5}, to{2, 3, 2.5};  // of length 6 along (2, 2, 1)/3

TEST(SegmentRule, KeepsThePartsInTheRegion) {
  // The line passes (0, 1, 1.5) at t = 1/2: a chord of the ball about it, with a bore of radius
  // 1/4.
  const Region shell = sphere({0, 1, 1.5}, 1) - sphere({0, 1, 1.5}, 0.25);
  const VolumePoints rule = make_segment_rule(RegionEvaluator(shell), from, to, 0.3, 3);
  EXPECT_NEAR(integral(rule, [](const Point&) { return 1.0; }), 1.5, 1e-14);
  EXPECT_NEAR(integral(rule, [](const Point& p) { return p[0]; }), 0, 1e-14);
  // x = 2s/3: ∫ x⁴ over 1/4 < |s| < 1.
  const double exact = 2 * std::pow(2.0 / 3, 4) * (1 - std::pow(0.25, 5)) / 5;
  EXPECT_NEAR(integral(rule, [](const Point& p) { return std::pow(p[0], 4); }), exact, 1e-14);
}

TEST(SegmentRule, IsExactToTheDegreeOfGaussRulesAndNoFurther) {
  const Region all = level_set(1.0 + pow(x_coordinate(), 2.0), 3);
  const VolumePoints rule = make_segment_rule(RegionEvaluator(all), {0, 0, 0}, {1, 0, 0}, 2, 3);
  EXPECT_EQ(rule.size(), 3);
  EXPECT_NEAR(integral(rule, [](const Point& p) { return std::pow(p[0], 5); }), 1.0 / 6, 1e-16);
  EXPECT_GT(std::fabs(integral(rule, [](const Point& p) { return std::pow(p[0], 6); }) - 1.0 / 7),
            1e-5);
}

TEST(SegmentRule, CountsTheBoundaryToTheClosedRegion) {
  const auto length = [](const Region& region, const Point& a, const Point& b) {
    return integral(make_segment_rule(RegionEvaluator(region), a, b, 0.3, 3),
                    [](const Point&) { return 1.0; });
  };
  // Along a slanted side, where values of its function are rounding of either sign; half of the
  // segment goes on beyond the corner. The same side from outside.
  const Point corner{0.1, 0.2}, end{1.1, 0.5};
  const Region side = half_plane(corner, {-0.3, 1}).named("side");
  const Region quarter = side & half_plane(corner, {1, 0.3}).named("other");
  const Point before{corner[0] - 1, corner[1] - 0.3};
  EXPECT_NEAR(length(quarter, corner, end), std::hypot(1, 0.3), 1e-14);
  EXPECT_NEAR(length(quarter, before, end), std::hypot(1, 0.3), 1e-14);
  const Region disk = circle({0.6, 0.35}, 0.2).named("disk");
  EXPECT_NEAR(length(disk - side, before, end), 0.4, 1e-14);
  // On two shapes that share the line; where it is all that both have in common it is no solid.
  EXPECT_NEAR(length((disk & side) | (disk - side), before, end), 0.4, 1e-14);
  // An edge of a cube in space, and off it by more than rounding.
  const Region cube = box({0, 0, 0}, {1, 1, 1}, 3).named("cube");
  EXPECT_NEAR(length(cube, {-1, 1, 1}, {3, 1, 1}), 1, 1e-14);
  EXPECT_EQ(length(cube, {-1, 1, 1 + 1e-7}, {3, 1, 1 + 1e-7}), 0);
}

TEST(SegmentRule, IsEmptyOutsideTheRegion) {
  const RegionEvaluator ball(sphere({5, 5, 5}, 1));
  EXPECT_EQ(make_segment_rule(ball, from, to, 0.3, 3).size(), 0);
  EXPECT_THROW(make_segment_rule(ball, from, to, 0, 3), InvalidArgument);
}

}  // namespace
