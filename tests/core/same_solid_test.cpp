#include "core/same_solid.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "core/bounding_box.hpp"
#include "core/primitives.hpp"

namespace rfm {
namespace {

TEST(SameSolid, TellsSetsApart) {
  const Region pair = circle({0, 0}, 1).named("a") | circle({1.5, 0}, 0.5).named("b");
  const RegionEvaluator evaluator(pair);
  const Box bounds = bounding_box(evaluator);
  const auto a = BooleanExpression::variable(0), b = BooleanExpression::variable(1);
  EXPECT_TRUE(same_solid(a | b, b | (a & b) | a, evaluator, bounds));
  EXPECT_TRUE(same_solid(a & b, a & b & b, evaluator, bounds));
  EXPECT_FALSE(same_solid(a | b, a, evaluator, bounds));
  EXPECT_FALSE(same_solid(a | b, a ^ !b, evaluator, bounds));
}

// Two boxes with a common side, without a hole, and the rectangle without the hole and with it.
TEST(SameSolid, SeesHolesOfAnySize) {
  for (const double radius : {0.1, 1e-3, 1e-6, 1e-9}) {
    const Region two = box({0, 0}, {1, 1}).named("a") | box({1, 0}, {2, 1}).named("b");
    const Region plate = two - circle({0.3123, 0.4217}, radius).named("hole");
    const RegionEvaluator evaluator(plate);
    const Box bounds{2, {0, 0}, {2, 1}};
    const auto v = [](int k) { return BooleanExpression::variable(k); };
    const BooleanExpression rectangle = v(0) & v(5) & v(2) & v(3);
    const BooleanExpression& form = plate.expression();
    EXPECT_TRUE(same_solid(form, rectangle & !v(8), evaluator, bounds)) << radius;
    EXPECT_FALSE(same_solid(form, rectangle, evaluator, bounds)) << radius;
  }
}

TEST(SameSolid, SeesGapsDownToRounding) {
  for (const double gap : {1e-1, 1e-4, 1e-9, 1e-11}) {
    const Region two = box({0, 0}, {1, 1}).named("a") | box({1 + gap, 0}, {2, 1}).named("b");
    const RegionEvaluator evaluator(two);
    const auto v = [](int k) { return BooleanExpression::variable(k); };
    const BooleanExpression rectangle = v(0) & v(5) & v(2) & v(3);
    EXPECT_FALSE(same_solid(two.expression(), rectangle, evaluator, {2, {0, 0}, {2, 1}})) << gap;
  }
}

TEST(SameSolid, SeesVoidsInSpace) {
  const Region two =
      box({0, 0, 0}, {1, 1, 1}, 3).named("a") | box({1, 0, 0}, {2, 1, 1}, 3).named("b");
  const Region solid = two - sphere({0.4123, 0.4217, 0.5531}, 0.002).named("void");
  const RegionEvaluator evaluator(solid);
  const Box bounds{3, {0, 0, 0}, {2, 1, 1}};
  const auto v = [](int k) { return BooleanExpression::variable(k); };
  const BooleanExpression brick = v(0) & v(7) & v(2) & v(3) & v(4) & v(5);
  EXPECT_TRUE(same_solid(solid.expression(), brick & !v(12), evaluator, bounds));
  EXPECT_FALSE(same_solid(solid.expression(), brick, evaluator, bounds));
}

// Six triangles around a point: where three lines meet two of the eight combinations of signs do
// not occur, and on these the union of the triangles and the hexagon differ.
TEST(SameSolid, KnowsWhichSignsOccurWhereLinesMeet) {
  const auto corner = [](int k, double shift) {
    const double t = k * std::numbers::pi / 3 + 0.2;
    return Point{std::cos(t) + shift, std::sin(t)};
  };
  std::vector<std::shared_ptr<const Primitive>> lines;
  const auto add = [&](const Region& line) { lines.push_back(line.primitives()[0]); };
  for (const double shift : {0.0, 0.01}) {
    lines.clear();
    BooleanExpression fan = BooleanExpression::constant(false);
    BooleanExpression hexagon = BooleanExpression::constant(true);
    const auto v = [](int k) { return BooleanExpression::variable(k); };
    // Spokes 0 to 2, with the left of each inside; one of them may miss the centre.
    for (int k = 0; k < 3; ++k) {
      const Point& p = corner(k, 0);
      add(half_plane({k == 2 ? shift : 0, 0}, {-p[1], p[0]}).named("spoke" + std::to_string(k)));
    }
    for (int k = 0; k < 6; ++k) {
      const Point a = corner(k, 0), b = corner(k + 1, 0);
      add(half_plane({0.5 * (a[0] + b[0]), 0.5 * (a[1] + b[1])}, {-a[0] - b[0], -a[1] - b[1]})
              .named("side" + std::to_string(k)));
      const BooleanExpression start = k < 3 ? v(k) : !v(k - 3);
      const BooleanExpression end = k < 2 ? !v(k + 1) : k < 5 ? v(k - 2) : !v(0);
      fan = fan | (start & end & v(3 + k));
      hexagon = hexagon & v(3 + k);
    }
    const RegionEvaluator evaluator(Region(2, lines, fan));
    EXPECT_EQ(same_solid(fan, hexagon, evaluator, {2, {-1, -1}, {1, 1}}), shift == 0) << shift;
  }
}

}  // namespace
}  // namespace rfm
