#include "core/point_program.hpp"

#include <gmock/gmock.h>

#include <random>

#include "core/evaluate.hpp"
#include "core/tape.hpp"

namespace rfm {
namespace {

const Field x = x_coordinate(), y = y_coordinate(), z = z_coordinate();

struct Case {
  const char* name;
  Field field;
};
void PrintTo(const Case& expression, std::ostream* out) { *out << expression.name; }

class PointPrograms : public testing::TestWithParam<Case> {};
INSTANTIATE_TEST_SUITE_P(
    PointProgram, PointPrograms,
    testing::Values(Case{"Constant", Field(2.5)}, Case{"Coordinate", z},
                    Case{"Quotient", x / (2 + y)},
                    Case{"Powers", pow(x, 5) - pow(y, 3) * z + pow(z, 8)},
                    Case{"Torus", 0.16 - pow(sqrt(x* x + y * y) - 1, 2) - z* z},
                    Case{"Gyroid", sin(x) * cos(y) + sin(y) * cos(z) + sin(z) * cos(x)},
                    Case{"Exponentials", exp(-x* y) + log(3 + z)},
                    Case{"Pieces", min(x* y, y - z) + max(x, -z* z)},
                    Case{"Hypot", hypot(x, y* z)}),
    [](const auto& info) { return info.param.name; });

TEST_P(PointPrograms, HaveValueAndSlopesOfTheExpression) {
  const auto program = PointProgram::compiled(GetParam().field, 3);
  ASSERT_TRUE(program);
  for (const Point& p : {Point{0.3, -0.7, 0.2}, Point{-1.1, 0.4, 0.9}, Point{2, 1.5, -1.3}}) {
    const PointJet jet = evaluate(GetParam().field, p, 1, 3);
    const double scale = 1 + std::fabs(jet.value());
    EXPECT_NEAR(program->value(p), jet.value(), 4e-16 * scale);
    Point gradient;
    EXPECT_EQ(program->value_and_gradient(p, gradient), program->value(p));
    for (int axis = 0; axis < 3; ++axis) {
      const double exact = jet.derivative(axis == 0, axis == 1, axis == 2);
      EXPECT_NEAR(gradient[axis], exact, 1e-14 * (1 + std::fabs(exact)));
      double slope = 0;
      EXPECT_EQ(program->value_and_slope(p, axis, slope), program->value(p));
      EXPECT_NEAR(slope, exact, 1e-14 * (1 + std::fabs(exact)));
    }
  }
}

// Both are Taylor models, of the same operations but for what is taken as a polynomial of degree
// two: of sums and products the bounds are the same, after roots and exponentials wider.
TEST_P(PointPrograms, BoundsHoldAndAreNotMuchWiderThanThoseOfATape) {
  const auto program = PointProgram::compiled(GetParam().field, 3);
  const Tape tape({GetParam().field}, {1}, 3);
  std::mt19937 generator(1);
  std::uniform_real_distribution<double> uniform(-1.5, 1.5), unit(0, 1);
  for (int i = 0; i < 200; ++i) {
    const double size = std::pow(10.0, -4 * unit(generator));
    Box box;
    box.dimension = 3;
    for (int axis = 0; axis < 3; ++axis) {
      box.low[axis] = uniform(generator);
      box.high[axis] = box.low[axis] + size * unit(generator);
    }
    const FunctionBounds bounds = program->bounds(box), others = tape.bounds(box);
    EXPECT_EQ(bounds.smooth, others.smooth);
    EXPECT_LE(bounds.value.width(), 1.4 * others.value.width() + 1e-13);
    for (int axis = 0; axis < 3; ++axis) {
      EXPECT_LE(bounds.gradient[axis].width(), 2.2 * others.gradient[axis].width() + 1e-12);
      EXPECT_EQ(bounds.gradient[axis].is_zero(), others.gradient[axis].is_zero());
    }
    for (int k = 0; k < 12; ++k) {
      Point point{}, gradient{};
      for (int axis = 0; axis < 3; ++axis)
        point[axis] = k < 8 ? (k >> axis & 1 ? box.high[axis] : box.low[axis])
                            : std::lerp(box.low[axis], box.high[axis], unit(generator));
      const double value = program->value_and_gradient(point, gradient);
      EXPECT_TRUE(bounds.value.contains(value)) << value << " " << bounds.value.low;
      for (int axis = 0; axis < 3; ++axis)
        EXPECT_TRUE(bounds.gradient[axis].contains(gradient[axis])) << axis;
    }
  }
}

TEST(PointProgram, SlopesOfARootAreZeroAtZeroLikeThoseOfJets) {
  Point gradient;
  const auto root = PointProgram::compiled(sqrt(x * x + y * y), 2);
  EXPECT_EQ(root->value_and_gradient({0, 0}, gradient), 0);
  EXPECT_EQ(gradient, (Point{0, 0, 0}));
}

TEST(PointProgram, OtherExpressionsAreLeftToTapes) {
  EXPECT_FALSE(PointProgram::compiled(x * time_coordinate(), 2));
  EXPECT_FALSE(PointProgram::compiled(parameter(0) * x, 2));
  EXPECT_FALSE(PointProgram::compiled(partial(x * x * y, 0), 2));
  EXPECT_FALSE(PointProgram::compiled(erf(x), 2));
  Field many = x;
  for (int k = 0; k < 100; ++k) many = many * y + x;
  EXPECT_FALSE(PointProgram::compiled(many, 2));
}

}  // namespace
}  // namespace rfm
