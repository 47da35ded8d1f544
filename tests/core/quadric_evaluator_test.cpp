#include "core/quadric_evaluator.hpp"

#include <gmock/gmock.h>

#include <random>

namespace rfm {
namespace {

const Field x = x_coordinate(), y = y_coordinate(), z = z_coordinate();

struct Case {
  const char* name;
  Field field;
};
void PrintTo(const Case& quadric, std::ostream* out) { *out << quadric.name; }

class QuadricEvaluators : public testing::TestWithParam<Case> {};
INSTANTIATE_TEST_SUITE_P(
    QuadricEvaluator, QuadricEvaluators,
    testing::Values(Case{"Plane", 1 + 2 * x - 3 * y + z}, Case{"AxisPlane", x - 0.3},
                    Case{"Sphere", 1 - x* x - y* y - pow(z - 1, 2)},
                    Case{"SphereFarAway", 1 - pow(x - 1000, 2) - pow(y + 700, 2) - z* z},
                    Case{"Saddle", x* y + y* z - 2 * z* x + 0.5},
                    Case{"TurnedCylinder", 1 - pow(x + 2 * z, 2) - pow(y - z, 2)},
                    Case{"Parabola", y - pow(x, 2)}),
    [](const auto& info) { return info.param.name; });

TEST_P(QuadricEvaluators, AgreeWithTheQuadric) {
  const QuadricEvaluator fast(*as_quadric(GetParam().field, 3));
  const Quadric& plain = fast;
  std::mt19937 generator(1);
  std::uniform_real_distribution<double> uniform(-3, 3);
  for (int i = 0; i < 200; ++i) {
    const Point p{fast.origin[0] + uniform(generator), fast.origin[1] + uniform(generator),
                  fast.origin[2] + uniform(generator)};
    EXPECT_NEAR(fast.value(p), plain.value(p), 2e-14);
    for (int axis = 0; axis < 3; ++axis)
      EXPECT_NEAR(fast.gradient(p)[axis], plain.gradient(p)[axis], 1e-14);
  }
}

TEST_P(QuadricEvaluators, BoundsHoldToTheLastDigitAndAreTight) {
  const QuadricEvaluator fast(*as_quadric(GetParam().field, 3));
  std::mt19937 generator(2);
  std::uniform_real_distribution<double> uniform(-3, 3), unit(0, 1);
  for (int i = 0; i < 300; ++i) {
    Box box;
    box.dimension = 3;
    const double size = std::pow(10.0, -3 * unit(generator));
    for (int axis = 0; axis < 3; ++axis) {
      box.low[axis] = fast.origin[axis] + uniform(generator);
      box.high[axis] = box.low[axis] + size * unit(generator);
    }
    const FunctionBounds bounds = fast.bounds(box);
    const Interval value = fast.value_bounds(box);
    for (int sample = 0; sample < 40; ++sample) {
      // Corners first, then points anywhere.
      Point p{};
      for (int axis = 0; axis < 3; ++axis)
        p[axis] = sample < 8 ? (sample >> axis & 1 ? box.high[axis] : box.low[axis])
                             : std::lerp(box.low[axis], box.high[axis], unit(generator));
      // The value in extended precision about the origin: no rounding to speak of.
      long double t[3], exact = fast.constant;
      for (int a = 0; a < 3; ++a) t[a] = static_cast<long double>(p[a]) - fast.origin[a];
      for (int a = 0; a < 3; ++a) {
        exact += fast.linear[a] * t[a];
        for (int b = 0; b < 3; ++b) exact += fast.square[Quadric::square_index(a, b)] * t[a] * t[b];
      }
      EXPECT_LE(bounds.value.low, exact);
      EXPECT_GE(bounds.value.high, exact);
      EXPECT_LE(value.low, exact);
      EXPECT_GE(value.high, exact);
      for (int a = 0; a < 3; ++a) {
        long double slope = fast.linear[a];
        for (int b = 0; b < 3; ++b) slope += 2 * fast.square[Quadric::square_index(a, b)] * t[b];
        EXPECT_LE(bounds.gradient[a].low, slope);
        EXPECT_GE(bounds.gradient[a].high, slope);
      }
    }
    // Hardly wider than those by intervals, which complete squares of mixed terms.
    const Interval careful = static_cast<const Quadric&>(fast).bounds(box).value;
    if (!careful.excludes_zero()) continue;
    EXPECT_LE(value.width(), 1.1 * careful.width() + 1e-12);
  }
}

TEST(QuadricEvaluator, SlopesThatVanishIdenticallyAreExactlyZero) {
  const QuadricEvaluator cylinder(*as_quadric(1 - x * x - y * y, 3));
  EXPECT_TRUE(cylinder.bounds({3, {0.3, 0.1, -2}, {0.4, 0.3, 5}}).gradient[2].is_zero());
}

}  // namespace
}  // namespace rfm
