#include "solvers/integrand.hpp"

#include <gmock/gmock.h>

#include "core/error.hpp"
#include "core/evaluate.hpp"

namespace rfm {
namespace {

const Field x = x_coordinate(), y = y_coordinate();

// The value of a coefficient for a point and a normal.
double value_of(const Coefficient& coefficient, const Point& point, const Point& normal) {
  double sum = 0;
  for (const auto& [power, field] : coefficient.terms()) {
    double term = value_at(field, point);
    for (int axis = 0; axis < 3; ++axis)
      for (int i = 0; i < power[axis]; ++i) term *= normal[axis];
    sum += term;
  }
  return sum;
}

TEST(Coefficient, IsAPolynomialInTheNormal) {
  const Coefficient n_x = Coefficient::normal(0), n_y = Coefficient::normal(1);
  const Coefficient a = x + n_x * y, b = 2.0 - n_y * n_x;
  const Point point{0.3, 0.7}, normal{0.6, -0.8};
  const double at_a = 0.3 + 0.6 * 0.7, at_b = 2 + 0.8 * 0.6;
  EXPECT_DOUBLE_EQ(value_of(a, point, normal), at_a);
  EXPECT_DOUBLE_EQ(value_of(b, point, normal), at_b);
  EXPECT_DOUBLE_EQ(value_of(a * b, point, normal), at_a * at_b);
  EXPECT_DOUBLE_EQ(value_of(a - b, point, normal), at_a - at_b);
  EXPECT_DOUBLE_EQ(value_of(-a, point, normal), -at_a);
  EXPECT_TRUE((a * b).depends_on_normal());
  EXPECT_FALSE(Coefficient(x).depends_on_normal());
}

TEST(Coefficient, KeepsNoTermsThatVanish) {
  EXPECT_TRUE(Coefficient(0.0).is_zero());
  EXPECT_TRUE((Coefficient(2.0) - 2.0).is_zero());
  EXPECT_TRUE((Coefficient::normal(2) * 0.0).is_zero());
  const Coefficient n = Coefficient::normal(0);
  EXPECT_EQ((n * x + n * y).terms().size(), 1u);
  EXPECT_THROW(Coefficient::normal(3), InvalidArgument);
}

TEST(QuadraticEnergy, KeepsOneEntryPerPairOfSlotsWhateverTheirOrder) {
  QuadraticEnergy energy;
  const Slot u{0, {}}, u_x{0, {1}}, v{1, {}};
  energy.add_stiffness(u_x, u, 2.0);
  energy.add_stiffness(u, u_x, x);
  energy.add_stiffness(v, v, 0.0);
  energy.add_load(v, y);
  energy.add_load(v, 1.0);
  EXPECT_EQ(energy.slots().size(), 3u);
  ASSERT_EQ(energy.stiffness().size(), 1u);
  EXPECT_LT(energy.stiffness()[0].row, energy.stiffness()[0].column);
  EXPECT_DOUBLE_EQ(value_of(energy.stiffness()[0].coefficient, {3, 0}, {}), 5);
  ASSERT_EQ(energy.load().size(), 1u);
  EXPECT_DOUBLE_EQ(value_of(energy.load()[0].coefficient, {0, 3}, {}), 4);
  EXPECT_FALSE(energy.depends_on_normal());
  energy.add_load(u, Coefficient::normal(1));
  EXPECT_TRUE(energy.depends_on_normal());
}

}  // namespace
}  // namespace rfm
