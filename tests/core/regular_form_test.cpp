#include "core/regular_form.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "core/bounding_box.hpp"
#include "core/evaluate.hpp"
#include "core/primitives.hpp"
#include "core/weight.hpp"

namespace rfm {
namespace {

std::optional<BooleanExpression> form_of(const Region& region) {
  const RegionEvaluator evaluator(region);
  return regular_form(evaluator, bounding_box(evaluator));
}

TEST(RegularForm, OfSquaresThatShareASideIsARectangle) {
  const Region two = box({0, 0}, {1, 1}).named("west") | box({1, 0}, {2, 1}).named("east");
  const auto form = form_of(two);
  ASSERT_TRUE(form);
  const RegionEvaluator evaluator(two);
  const Weight omega = weight(*form, evaluator, bounding_box(evaluator));
  // x (2 − x) y (1 − y), by either of the two sides that are flush.
  EXPECT_NEAR(value_at(omega.function, {1, 0.5}), 0.25, 1e-15);
  EXPECT_NEAR(value_at(omega.function, {0.3, 0.2}), 0.3 * 1.7 * 0.2 * 0.8, 1e-15);
}

TEST(RegularForm, OfBoxesWithFlushSidesUsesEachSideOnce) {
  const Region ell = box({0, 0}, {2, 1}).named("flat") | box({0, 0}, {1, 2}).named("upright");
  const auto form = form_of(ell);
  ASSERT_TRUE(form);
  int literals = 0;
  for (const auto& node : form->nodes())
    literals += node.kind == BooleanExpression::Kind::variable ? 1 : 0;
  EXPECT_EQ(literals, 6);  // four sides, and a sum of the two at the reentrant corner
}

// Cylinders end to end on slanted axes: their ends lie within 1e-15 of each other.
TEST(RegularForm, OfShaftsThatAreFlushDoesNotDependOnRounding) {
  for (const double unit : {1.0, 1000.0})
    for (const Point& axis : {Point{1, 1, -2}, Point{1, 2, 3}, Point{3, -1, 0.7}}) {
      const double length = std::hypot(axis[0], axis[1], axis[2]);
      const Point first{2 * unit, 6 * unit, 9 * unit};
      Point second = first;
      for (int i = 0; i < 3; ++i) second[i] += 2.5 * unit * axis[i] / length;
      const Region shaft = cylinder(first, axis, 5 * unit, 3 * unit).named("a") |
                           cylinder(second, axis, 3 * unit, 2 * unit).named("b");
      EXPECT_TRUE(form_of(shaft)) << unit << ", " << axis[2];
    }
}

TEST(RegularForm, IsNotLookedForWithoutNeedNorFoundWhereThereIsNone) {
  EXPECT_FALSE(form_of(circle({0, 0}, 1).named("a") | circle({1, 0}, 1).named("b")));
  EXPECT_FALSE(form_of(box({0, 0}, {1, 1}).named("a")));
  Region disks = circle({1, 0}, 1).named("d0");
  for (int k = 1; k < 3; ++k) {
    const double t = 2 * std::numbers::pi * k / 3;
    disks = disks | circle({std::cos(t), std::sin(t)}, 1).named("d" + std::to_string(k));
  }
  EXPECT_FALSE(form_of(disks));
}

}  // namespace
}  // namespace rfm
