#include "quadrature/rotated_frame.hpp"

#include <gmock/gmock.h>

#include "tests/quadrature/regions.hpp"

using namespace rfm;
using namespace rfm::test;

namespace {

Box unit_box() {
  Box box;
  box.low = {0.1, 0.2, 0};
  box.high = {0.4, 0.6, 0};
  return box;
}

struct Curves {
  std::vector<LevelFunction> levels;
  std::vector<Surface> surfaces;
  ActiveSet active;

  explicit Curves(const std::vector<Field>& fields) {
    BooleanExpression all = BooleanExpression::variable(0);
    std::vector<int> numbers;
    for (std::size_t i = 0; i < fields.size(); ++i) {
      levels.emplace_back(fields[i], 2);
      numbers.push_back(static_cast<int>(i));
      if (i > 0) all = all & BooleanExpression::variable(static_cast<int>(i));
    }
    for (const LevelFunction& level : levels) surfaces.emplace_back(level);
    active.table = TruthTable(all, numbers, std::vector<Truth>(fields.size(), Truth::unknown));
    for (std::size_t i = 0; i < fields.size(); ++i) active.add(surfaces[i], static_cast<int>(i));
  }
};

TEST(RotatedFrame, SeesTheSameValuesAndRotatedGradients) {
  const Curves curves({y() - square(x()) - 0.3, x() - square(y()) + 0.01 * y()});
  const auto rotated = RotatedBox::around(unit_box(), curves.active);
  ASSERT_TRUE(rotated);
  ASSERT_EQ(rotated->active().region_count(), 6);
  const Point local{0.03, -0.02, 0}, world = rotated->frame().to_world(local);
  for (int i = 0; i < 2; ++i) {
    Point in_frame{}, in_world{};
    const double value = rotated->active().surfaces[i]->value_and_gradient(local, in_frame);
    EXPECT_DOUBLE_EQ(value, curves.surfaces[i].value_and_gradient(world, in_world));
    const Point back = rotated->frame().rotate(in_frame);
    EXPECT_NEAR(back[0], in_world[0], 1e-15);
    EXPECT_NEAR(back[1], in_world[1], 1e-15);
  }
}

TEST(RotatedFrame, HoldsExactlyTheBox) {
  const Curves curves({y() - square(x()) - 0.3, x() - square(y()) + 0.01 * y()});
  const auto rotated = RotatedBox::around(unit_box(), curves.active);
  ASSERT_TRUE(rotated);
  for (double u = 0; u <= 1; u += 0.05)
    for (double v = 0; v <= 1; v += 0.05) {
      const Box& box = rotated->box();
      const Point local{box.low[0] + u * box.length(0), box.low[1] + v * box.length(1), 0};
      bool inside = true;
      for (int side = 2; side < 6; ++side)
        inside &= rotated->active().surfaces[side]->value(local) >= 0;
      EXPECT_EQ(inside, unit_box().contains(rotated->frame().to_world(local)));
    }
}

TEST(RotatedFrame, BoundsEncloseValuesAndGradients) {
  const Curves curves({y() - square(x()) - 0.3, x() - square(y()) + 0.01 * y()});
  const auto rotated = RotatedBox::around(unit_box(), curves.active);
  ASSERT_TRUE(rotated);
  const Box& box = rotated->box();
  for (int i = 0; i < rotated->active().count; ++i) {
    const Surface& surface = *rotated->active().surfaces[i];
    const FunctionBounds bounds = surface.bounds(box);
    for (double u = 0; u <= 1; u += 0.25)
      for (double v = 0; v <= 1; v += 0.25) {
        Point gradient{};
        const double value = surface.value_and_gradient(
            {box.low[0] + u * box.length(0), box.low[1] + v * box.length(1), 0}, gradient);
        EXPECT_TRUE(bounds.value.low <= value + 1e-15 && value - 1e-15 <= bounds.value.high);
        for (int axis = 0; axis < 2; ++axis)
          EXPECT_TRUE(bounds.gradient[axis].low <= gradient[axis] + 1e-15 &&
                      gradient[axis] - 1e-15 <= bounds.gradient[axis].high);
      }
  }
}

TEST(RotatedFrame, IsNotForOneCurveNorForParallelsToAnAxis) {
  EXPECT_FALSE(RotatedBox::around(unit_box(), Curves({y() - square(x()) - 0.3}).active));
  EXPECT_FALSE(RotatedBox::around(unit_box(), Curves({y() - square(x()) - 0.3, x() - 0.3}).active));
}

TEST(RotatedFrame, TellsWhereACurveTouchesASideOfTheBox) {
  // At a corner of the box, within a side, and nowhere.
  const Box box{2, {-1, -1, 0}, {0, 0, 0}};
  const Field steep = x() + 0.4 - 0.3 * y();
  const auto touches = [&](const Field& field) {
    const Curves curves({field, steep});
    const auto rotated = RotatedBox::around(box, curves.active);
    EXPECT_TRUE(rotated);
    return rotated && rotated->touches_side();
  };
  EXPECT_TRUE(touches(square(x()) - y() - 1));
  EXPECT_TRUE(touches(square(x() + 0.3) - y() - 1));
  EXPECT_FALSE(touches(square(x() + 0.3) - y() - 0.999));
  EXPECT_FALSE(touches(x() - y() + 0.2));
}

}  // namespace
