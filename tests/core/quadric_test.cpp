#include "core/quadric.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <numbers>
#include <random>

#include "core/evaluate.hpp"
#include "core/primitives.hpp"

namespace rfm {
namespace {

const Field x = x_coordinate(), y = y_coordinate(), z = z_coordinate();

Field level_of(const Region& region) { return region.primitives()[0]->level; }

struct Case {
  const char* name;
  Field field;
  int dimension;
};
void PrintTo(const Case& quadric, std::ostream* out) { *out << quadric.name; }

class Quadrics : public testing::TestWithParam<Case> {};
INSTANTIATE_TEST_SUITE_P(
    Quadric, Quadrics,
    testing::Values(Case{"HalfPlane", level_of(half_plane({1, 2}, {3, -4})), 2},
                    Case{"Circle", level_of(circle({0.3, -0.2}, 0.7)), 2},
                    Case{"Ellipse", level_of(ellipse({0.3, -0.2}, {1.5, 0.4}, 0.6)), 2},
                    Case{"Expanded", 3 - 2 * x + 5 * x* y - (x - y) * (2 * x + 1) / 4, 2},
                    Case{"Parabola", y - pow(x, 2), 2},
                    Case{"TurnedParabola", pow(x + y, 2) + x - y - 1, 2},
                    Case{"Hyperbola", x* y - 1, 2}, Case{"Constant", Field(2.0), 2},
                    Case{"Interval", (x - 1) * (2 - x), 1},
                    Case{"Sphere", 1 - x* x - y* y - pow(z - 1, 2), 3},
                    Case{"Cylinder", 1 - pow(x + z, 2) - pow(y, 2), 3},
                    Case{"Saddle", x* y + y* z - 2 * z* x + 0.5, 3}, Case{"WithoutZ", x* x + z, 2}),
    [](const auto& info) { return info.param.name; });

TEST_P(Quadrics, HaveTheValuesAndGradientsOfTheirExpressions) {
  const auto& [name, field, dimension] = GetParam();
  const auto quadric = as_quadric(field, dimension);
  ASSERT_TRUE(quadric);
  std::mt19937 generator(1);
  std::uniform_real_distribution<double> uniform(-3, 3);
  for (int i = 0; i < 100; ++i) {
    Point point{};
    for (int axis = 0; axis < dimension; ++axis) point[axis] = uniform(generator);
    const PointJet jet = evaluate(field, point, 1, dimension);
    EXPECT_NEAR(quadric->value(point), jet.value(), 4e-13);
    const Point gradient = quadric->gradient(point);
    for (int axis = 0; axis < dimension; ++axis) {
      const double slope = jet.derivative(axis == 0, axis == 1, axis == 2);
      EXPECT_NEAR(gradient[axis], slope, 2e-13);
      EXPECT_EQ(quadric->slope(point, axis), gradient[axis]);
    }
  }
}

TEST_P(Quadrics, BoundsHoldAndGradientsAreExact) {
  const auto& [name, field, dimension] = GetParam();
  const auto quadric = as_quadric(field, dimension);
  ASSERT_TRUE(quadric);
  std::mt19937 generator(2);
  std::uniform_real_distribution<double> uniform(-3, 3), unit(0, 1);
  for (int i = 0; i < 200; ++i) {
    Box box;
    box.dimension = dimension;
    for (int axis = 0; axis < dimension; ++axis) {
      box.low[axis] = uniform(generator);
      box.high[axis] = box.low[axis] + unit(generator);
    }
    const FunctionBounds bounds = quadric->bounds(box);
    const Interval plain = quadric->value_bounds(box);
    // Affine slopes take their extremes at corners.
    std::array<Interval, 3> corners;
    for (int corner = 0; corner < 8; ++corner) {
      Point point{};
      for (int axis = 0; axis < dimension; ++axis)
        point[axis] = corner >> axis & 1 ? box.high[axis] : box.low[axis];
      const Point gradient = quadric->gradient(point);
      for (int axis = 0; axis < dimension; ++axis)
        corners[axis] =
            corner == 0 ? Interval(gradient[axis]) : hull(corners[axis], Interval(gradient[axis]));
    }
    for (int axis = 0; axis < dimension; ++axis) {
      EXPECT_NEAR(bounds.gradient[axis].low, corners[axis].low, 1e-13);
      EXPECT_NEAR(bounds.gradient[axis].high, corners[axis].high, 1e-13);
    }
    for (int sample = 0; sample < 20; ++sample) {
      Point point{};
      for (int axis = 0; axis < dimension; ++axis)
        point[axis] = std::lerp(box.low[axis], box.high[axis], unit(generator));
      const double value = quadric->value(point);
      EXPECT_LE(bounds.value.low, value + 1e-14);
      EXPECT_GE(bounds.value.high, value - 1e-14);
      EXPECT_LE(plain.low, value + 1e-14);
      EXPECT_GE(plain.high, value - 1e-14);
    }
  }
}

TEST(Quadric, BoundsOfACircleAreItsRange) {
  // 1 − x² − y² over [−1/2, 1] × [1/4, 1/2].
  const auto quadric = as_quadric(1 - x * x - y * y, 2);
  const Interval range = quadric->value_bounds({2, {-0.5, 0.25}, {1, 0.5}});
  EXPECT_NEAR(range.low, -0.25, 1e-15);
  EXPECT_NEAR(range.high, 1 - 0.0625, 1e-15);
}

TEST(Quadric, MixedTermsDoNotSpoilTheBoundsOfAThinTurnedEllipse) {
  // Along the diagonal with radii 1 and 0.01; on this box |y − x| ≥ 0.05, so that 1 − ξ² − η² is at
  // most 1 − 0.05²/(2 · 0.01²) = −11.5. Term by term the upper bound would be above 1000.
  const auto quadric = as_quadric(level_of(ellipse({0, 0}, {1, 0.01}, std::numbers::pi / 4)), 2);
  const double upper = quadric->value_bounds({2, {0.5, 0.2}, {1, 0.45}}).high;
  EXPECT_LT(upper, -11.4);
  EXPECT_GT(upper, -13);
}

TEST(Quadric, BoundsOverAFaceThatTouchesAreTheRangeToRounding) {
  // A cone of 45° whose axis rises by 45° touches the plane of its apex along a line: over a face
  // of a box there its range is […, 0], wherever the face lies in the plane.
  const double c = std::sqrt(0.5);
  const auto cone = as_quadric(
      pow(0.5 * x - 0.5 * y + c * (z + 0.75), 2) - 0.5 * (x * x + y * y + pow(z + 0.75, 2)), 3);
  ASSERT_TRUE(cone);
  for (const double t : {0.0, 0.1, 0.37, 2.0}) {
    const Interval range =
        cone->value_bounds({3, {t, -t - 0.003, -0.75}, {t + 0.001, -t + 0.001, -0.75}});
    EXPECT_GE(range.high, 0);
    EXPECT_LT(range.high, 1e-14 * (1 + t * t));
    EXPECT_NEAR(range.low, -0.25 * 0.003 * 0.003, 1e-14 * (1 + t * t));
  }
}

TEST(Quadric, OtherFunctionsAreRefused) {
  for (const Field& f : {x * x * y, pow(x, 3), sin(x), 1 / x, sqrt(x * x), x * time_coordinate(),
                         abs(x), parameter(0) * x, partial(x * x, 0)})
    EXPECT_FALSE(as_quadric(f, 2));
}

TEST(Quadric, ATinyCircleFarAwayKeepsItsDigits) {
  const double radius = 1e-6;
  const auto quadric = as_quadric(level_of(circle({1000, -1000}, radius)), 2);
  ASSERT_TRUE(quadric);
  for (const double t : {0.0, 0.5, 0.99, 1.01}) {
    const double dx = 1000 + t * radius * 0.6 - 1000, dy = -1000 + t * radius * 0.8 + 1000;
    const double exact = (radius * radius - dx * dx - dy * dy) / (2 * radius);
    EXPECT_NEAR(quadric->value({1000 + t * radius * 0.6, -1000 + t * radius * 0.8}), exact,
                1e-13 * radius);
  }
}

TEST(Quadric, ATinyTurnedEllipseFarAwayKeepsItsDigits) {
  const double a = 2e-5, b = 1e-5, angle = 0.7, c = std::cos(angle), s = std::sin(angle);
  const auto quadric = as_quadric(level_of(ellipse({1000, -700}, {a, b}, angle)), 2);
  ASSERT_TRUE(quadric);
  for (double t = 0; t < 6.28; t += 0.5) {
    const Point point{1000 + a * std::cos(t), -700 + a * std::sin(t)};
    const double dx = point[0] - 1000, dy = point[1] + 700;
    const double xi = (c * dx + s * dy) / a, eta = (c * dy - s * dx) / b;
    EXPECT_NEAR(quadric->value(point), 1 - xi * xi - eta * eta, 1e-13);
  }
}

TEST(Quadric, TheOriginIsTheCentreWhereThereIsOne) {
  const auto ellipse_level = as_quadric(level_of(ellipse({3, -2}, {2, 1}, 0.7)), 2);
  EXPECT_NEAR(ellipse_level->origin[0], 3, 1e-14);
  EXPECT_NEAR(ellipse_level->origin[1], -2, 1e-14);
  const auto hyperbola = as_quadric((x - 5) * (y + 7) - 1, 2);
  EXPECT_NEAR(hyperbola->origin[0], 5, 1e-14);
  EXPECT_NEAR(hyperbola->origin[1], -7, 1e-14);
  // The nearly straight keeps the coordinate origin.
  const auto arc = as_quadric(x + y - 1e-12 * x * x, 2);
  EXPECT_NEAR(arc->value({1, -1}), -1e-12, 2e-16);
  // A cylinder has a line of centres, a parabola none.
  EXPECT_TRUE(as_quadric(1 - pow(x + z, 2) - pow(y - 4, 2), 3));
  EXPECT_TRUE(as_quadric(y - pow(x - 3, 2), 2));
}

}  // namespace
}  // namespace rfm
