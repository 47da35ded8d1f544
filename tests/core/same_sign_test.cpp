#include "core/same_sign.hpp"

#include <gtest/gtest.h>

#include "core/evaluate.hpp"

namespace rfm {
namespace {

const Field x = x_coordinate(), y = y_coordinate(), inside = 1.0 - x * x - y * y;

TEST(SameSign, TakesOffWhatKeepsIt) {
  for (const Field& f : {cbrt(inside), pow(inside, 3.0), tanh(inside), atan(sinh(inside)),
                         asinh(erf(inside)), 2.0 * inside, inside * exp(x), inside / cosh(x * y),
                         -(-3.0 * cbrt(inside)), cbrt(-1.0 * inside) * -exp(y)})
    EXPECT_TRUE(simplest_of_same_sign(f).same_as(inside));
}

TEST(SameSign, LeavesWhatMayChangeIt) {
  for (const Field& f : {inside, pow(inside, 2.0), abs(inside), exp(inside), inside * x,
                         inside / (1.0 + x), inside * exp(log(x)), sin(inside), pow(inside, -1.0),
                         inside + 1e-3 * cbrt(inside), tan(inside)})
    EXPECT_TRUE(simplest_of_same_sign(f).same_as(f));
  EXPECT_TRUE(simplest_of_same_sign(Field(2.0)).is_constant(2.0));
}

TEST(SameSign, HoldsAtPointsOfAllSides) {
  const Field f = -pow(cbrt(0.5 - x) / -cosh(y), 5.0) * exp(-y);
  const Field simple = simplest_of_same_sign(f);
  EXPECT_FALSE(simple.same_as(f));
  for (const double at : {-1.0, 0.0, 0.5, 0.75, 2.0}) {
    const Point point{at, 0.3, 0};
    EXPECT_EQ(value_at(f, point) > 0, value_at(simple, point) > 0) << at;
    EXPECT_EQ(value_at(f, point) < 0, value_at(simple, point) < 0) << at;
  }
}

}  // namespace
}  // namespace rfm
