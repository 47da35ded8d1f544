#include "core/weight.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "core/bounding_box.hpp"
#include "core/evaluate.hpp"
#include "core/primitives.hpp"

using namespace rfm;

namespace {

Weight weight_of(const Region& region, CombineRule rule = CombineRule::automatic) {
  const RegionEvaluator evaluator(region);
  return weight(evaluator, bounding_box(evaluator), rule);
}

// The regular polygon with `sides` sides about the origin, at distance 1 from it.
Region regular_polygon(int sides) {
  const auto side = [&](int k) {
    const double angle = 2 * std::numbers::pi * (k + 0.3) / sides;
    const double c = std::cos(angle), s = std::sin(angle);
    return half_plane({c, s}, {-c, -s}).named("side" + std::to_string(k));
  };
  Region region = side(0);
  for (int k = 1; k < sides; ++k) region = region & side(k);
  return region;
}

const Region ring = circle({0, 0}, 1).named("outer") - circle({0.2, 0.1}, 0.35).named("inner");

TEST(Weight, IsPositiveInsideAndZeroOnTheBoundary) {
  for (const CombineRule rule :
       {CombineRule::automatic, CombineRule::r0, CombineRule::r1, CombineRule::product}) {
    const Field omega = weight_of(ring, rule).function;
    for (const Point& inside : {Point{0.7, 0, 0}, Point{-0.5, 0.5, 0}, Point{0, -0.9, 0}})
      EXPECT_GT(value_at(omega, inside), 0);
    for (const double t : {0.3, 2.0, 4.1}) {
      EXPECT_NEAR(value_at(omega, {std::cos(t), std::sin(t), 0}), 0, 1e-15);
      EXPECT_NEAR(value_at(omega, {0.2 + 0.35 * std::cos(t), 0.1 + 0.35 * std::sin(t), 0}), 0,
                  1e-15);
    }
  }
}

TEST(Weight, BoundariesThatDoNotMeetMultiply) {
  EXPECT_EQ(weight_of(ring).formula, "omega(outer) * -omega(inner)");
}

TEST(Weight, SidesAtRightAnglesMultiply) {
  EXPECT_EQ(weight_of(box({0, 0}, {2, 1}).named("plate")).formula,
            "omega(plate.left) * omega(plate.right) * omega(plate.bottom) * omega(plate.top)");
  EXPECT_EQ(weight_of(regular_polygon(4)).formula,
            "omega(side0) * omega(side1) * omega(side2) * omega(side3)");
}

TEST(Weight, SidesAtAcuteAnglesMultiply) {
  EXPECT_EQ(weight_of(regular_polygon(3)).formula, "omega(side0) * omega(side1) * omega(side2)");
}

TEST(Weight, SidesAtObtuseAnglesJoinByR0) {
  EXPECT_EQ(weight_of(regular_polygon(6)).formula,
            "r0_and(r0_and(r0_and(r0_and(r0_and(omega(side0), omega(side1)), omega(side2)), "
            "omega(side3)), omega(side4)), omega(side5))");
}

TEST(Weight, ReentrantCornersAreDisjunctions) {
  const Region l_shape = box({0, 0}, {2, 2}).named("whole") - box({1, 1}, {3, 3}).named("notch");
  const Weight omega = weight_of(l_shape);
  EXPECT_NE(omega.formula.find("r0_or(-omega(notch.left), -omega(notch.bottom))"),
            std::string::npos)
      << omega.formula;
  EXPECT_GT(value_at(omega.function, {1.5, 0.5, 0}), 0);
  EXPECT_GT(value_at(omega.function, {1, 0.5, 0}), 0);  // beyond the edge x = 1
  EXPECT_NEAR(value_at(omega.function, {1, 1.5, 0}), 0, 1e-15);
}

TEST(Weight, ConjunctsThatDoNotTouchTheRegionAreLeftOut) {
  const Region disk = circle({0, 0}, 1).named("disk") & half_plane({5, 0}, {-1, 0}).named("far");
  EXPECT_EQ(weight_of(disk).formula, "omega(disk)");
}

TEST(Weight, VanishesToFirstOrder) {
  // u − g = O(ω) needs a normal derivative that is not zero.
  const PointJet jet = evaluate(weight_of(ring).function, {std::cos(1.0), std::sin(1.0), 0}, 1, 2);
  EXPECT_GT(std::hypot(jet.derivative(1, 0), jet.derivative(0, 1)), 0.1);
}

}  // namespace
