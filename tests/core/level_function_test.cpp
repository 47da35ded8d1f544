#include "core/level_function.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <random>

#include "core/primitives.hpp"

namespace rfm {
namespace {

const Field x = x_coordinate(), y = y_coordinate(), z = z_coordinate();

// The same function in a form that is not recognised as a polynomial.
Field disguised(const Field& f) {
  return f + 0.0 * x + (exp(Field(0.0) * x) - 1) + sin(x) - sin(x);
}

TEST(LevelFunction, PolynomialsOfDegreeTwoAreRecognised) {
  EXPECT_TRUE(LevelFunction(1 - x * x - y * y, 2).is_quadric());
  EXPECT_TRUE(LevelFunction(x, 2).is_quadric());
  EXPECT_FALSE(LevelFunction(1 - pow(x, 4), 2).is_quadric());
  EXPECT_FALSE(LevelFunction(disguised(1 - x * x), 2).is_quadric());
}

TEST(LevelFunction, BothPathsAgree) {
  const Field f = 1 - x * x / 4 - pow(y - x / 3, 2) + z * x;
  const LevelFunction quadric(f, 3), tape(disguised(f), 3);
  ASSERT_TRUE(quadric.is_quadric());
  ASSERT_FALSE(tape.is_quadric());
  std::mt19937 generator(1);
  std::uniform_real_distribution<double> uniform(-2, 2);
  for (int i = 0; i < 100; ++i) {
    const Point point{uniform(generator), uniform(generator), uniform(generator)};
    Point p, q;
    EXPECT_NEAR(quadric.value(point), tape.value(point), 1e-14);
    EXPECT_NEAR(quadric.value_and_gradient(point, p), tape.value_and_gradient(point, q), 1e-14);
    for (int axis = 0; axis < 3; ++axis) {
      double slope;
      EXPECT_NEAR(p[axis], q[axis], 1e-14);
      EXPECT_EQ(tape.value_and_slope(point, axis, slope), tape.value(point));
      EXPECT_EQ(slope, q[axis]);
      EXPECT_NEAR(quadric.value_and_slope(point, axis, slope), quadric.value(point), 1e-15);
      EXPECT_EQ(slope, p[axis]);
    }
    Box box{3, point, point};
    for (int axis = 0; axis < 3; ++axis) box.high[axis] += 0x1p-6;
    for (const LevelFunction* level : {&quadric, &tape}) {
      const FunctionBounds bounds = level->bounds(box);
      EXPECT_TRUE(bounds.smooth);
      EXPECT_TRUE(bounds.value.contains(quadric.value(box.center())));
      EXPECT_TRUE(level->value_bounds(box).contains(quadric.value(box.center())));
      for (int axis = 0; axis < 3; ++axis) EXPECT_TRUE(bounds.gradient[axis].contains(p[axis]));
    }
    EXPECT_LT(tape.bounds(box).value.width(), quadric.bounds(box).value.width() + 3 * 0x1p-12);
  }
}

TEST(LevelFunction, BoundsAreOfSecondOrder) {
  // The width beyond the linear part, Σ |∂f| h, falls fourfold when the box is halved.
  const LevelFunction level(sin(3 * x) * exp(y) - 0.3, 2);
  const auto excess = [&](double h) {
    const Box box{2, {0.4 - h, 0.2 - h}, {0.4 + h, 0.2 + h}};
    Point gradient;
    level.value_and_gradient(box.center(), gradient);
    return level.bounds(box).value.width() -
           2 * h * (std::fabs(gradient[0]) + std::fabs(gradient[1]));
  };
  EXPECT_GT(excess(0x1p-6) / excess(0x1p-7), 3.7);
  EXPECT_LT(excess(0x1p-6), 20 * 0x1p-12);
}

TEST(LevelFunction, DerivativesThatVanishIdenticallyAreExactlyZero) {
  const Box box{2, {0.1, 0.2}, {0.7, 0.9}};
  for (const Field& f : {Field(1 - x * x), disguised(x * 3 - 1), exp(sin(x)), sqrt(1 + x * x),
                         apply(Operation::r0_conjunction, {x, 1 - x}), pow(x, 0.3) / (2 + x)}) {
    EXPECT_TRUE(LevelFunction(f, 2).bounds(box).gradient[1].is_zero());
    EXPECT_FALSE(LevelFunction(f, 2).bounds(box).gradient[0].is_zero());
  }
}

TEST(LevelFunction, KinksAreNotCalledSmooth) {
  const LevelFunction level(abs(x) - y, 2);
  EXPECT_FALSE(level.bounds({2, {-1, 0}, {1, 1}}).smooth);
  EXPECT_TRUE(level.bounds({2, {0.1, 0}, {1, 1}}).smooth);
  EXPECT_FALSE(LevelFunction(sqrt(x * x + y * y) - 1, 2).bounds({2, {-1, -1}, {1, 1}}).smooth);
  EXPECT_FALSE(LevelFunction(max(x, y), 2).bounds({2, {0, 0}, {1, 1}}).smooth);
}

// A piecewise linear function with knots.
class Knots : public FieldSource {
 public:
  explicit Knots(std::vector<double> knots) : knots_(std::move(knots)) {}
  void evaluate(const std::array<const double*, 3>& coordinates, int count, int variables,
                int order, double* jets, int stride) const override {
    for (int i = 0; i < count; ++i) {
      for (int k = 0; k < jet_size(variables, order); ++k) jets[k * stride + i] = 0;
      jets[i] = coordinates[0][i];
      if (order > 0) jets[stride + i] = 1;
    }
  }
  FunctionBounds bounds(const Box& box) const override { return {box.interval(0), {1.0}, true}; }
  std::vector<double> breakpoints(int axis) const override {
    return axis == 0 ? knots_ : std::vector<double>{};
  }
  Box valid() const override { return {2, {0, 0}, {1, 1}}; }

 private:
  std::vector<double> knots_;
};

TEST(LevelFunction, BreakpointsAreThoseOfAllSourcesInOrder) {
  const Field a = field(std::make_shared<Knots>(std::vector{0.1, 0.5})),
              b = field(std::make_shared<Knots>(std::vector{0.3, 0.5}));
  const LevelFunction level(a * sin(b) + a, 2);
  EXPECT_THAT(level.breakpoints(0), testing::ElementsAre(0.1, 0.3, 0.5));
  EXPECT_TRUE(level.breakpoints(1).empty());
  EXPECT_TRUE(LevelFunction(sin(x), 2).breakpoints(0).empty());
}

}  // namespace

// Bounds along a line of a quadric, of a tape, and of a tape with derivatives in the expression
// (those have no short cut).
TEST(LevelFunction, BoundsAlongALineEncloseValuesAndSlopesAndShrinkWithOrderTwo) {
  const Field x = x_coordinate(), y = y_coordinate(), z = z_coordinate();
  const Field wave = sin(3 * x) * exp(y) + z * z * x;
  const std::vector<Field> fields{x * x - 2 * x * y + 0.3 * z * z - 0.1 * y, wave,
                                  partial(wave, 0) + y * partial(wave, 1)};
  const Line line{{0.2, -0.1, 0.4}, {0.7, 0.3, -1.1}};
  for (const Field& field : fields) {
    const LevelFunction level(field, 3);
    const auto excess = [&](double length) {
      const Interval range(0.4 - length / 2, 0.4 + length / 2);
      const LineBounds bounds = level.bounds(line, range);
      EXPECT_TRUE(bounds.smooth);
      constexpr int samples = 101;
      double low = INFINITY, high = -INFINITY, slope = 0;
      for (int i = 0; i < samples; ++i) {
        const double t = range.low + (range.high - range.low) * i / (samples - 1);
        const double value = level.value_and_slope(line, t, slope);
        EXPECT_TRUE(bounds.value.contains(value) && bounds.slope.contains(slope)) << "at " << t;
        low = std::min(low, value);
        high = std::max(high, value);
      }
      return bounds.value.width() - (high - low);
    };
    const double coarse = excess(0.1), fine = excess(0.01);
    EXPECT_LT(fine, 0.03 * coarse + 1e-14);
    EXPECT_LT(coarse, 0.2);
  }
}

TEST(LevelFunction, OfDegreeTwoIsAPolynomialAlongALine) {
  const Field x = x_coordinate(), y = y_coordinate(), z = z_coordinate();
  const LevelFunction level(1 - x * x + 3 * x * y - y * z + 2 * z, 3);
  const Line line{{0.2, -0.1, 0.4}, {0.7, 0.3, -1.1}};
  const auto polynomial = level.polynomial_along(line);
  ASSERT_TRUE(polynomial);
  for (const double t : {-1.0, 0.0, 0.3, 2.0})
    EXPECT_NEAR(polynomial->value(t), level.value(line.at(t)), 1e-14);
  EXPECT_FALSE(LevelFunction(x * x * x, 3).polynomial_along(line));
}

}  // namespace rfm
