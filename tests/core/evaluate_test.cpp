#include "core/evaluate.hpp"

#include <gmock/gmock.h>

#include <cmath>

#include "core/error.hpp"

namespace rfm {
namespace {

const Field x = x_coordinate(), y = y_coordinate(), z = z_coordinate();

TEST(Evaluate, GivesDerivativesOfEveryOrderByTheirNames) {
  const PointJet f = evaluate(x * x * x * y * y + z, {2, 3, 5}, 3);
  EXPECT_EQ(f.value(), 77);
  EXPECT_EQ(f.derivative(0), 77);
  EXPECT_EQ(f.derivative(1), 108);
  EXPECT_EQ(f.derivative(2, 1), 72);
  EXPECT_EQ(f.derivative(0, 0, 1), 1);
  EXPECT_EQ(f.derivative(1, 1, 1), 0);
  EXPECT_EQ(evaluate(x * x * y * y, {2, 3}, 4, 2).derivative(2, 2), 4);
}

TEST(Evaluate, DerivativesThatWereNotComputedAreRefused) {
  const PointJet f = evaluate(x * y, {2, 3}, 1, 2);
  EXPECT_THROW(f.derivative(1, 1), InvalidArgument);
  EXPECT_THROW(f.derivative(0, 0, 1), InvalidArgument);  // there is no z in two variables
  EXPECT_THROW(f.derivative(-1), InvalidArgument);
  EXPECT_THROW(evaluate(x, {2, 3}, -1), InvalidArgument);
}

TEST(Evaluate, ValueTakesTheTime) {
  EXPECT_EQ(value_at(x + z * time_coordinate(), {1, 2, 3}, 4), 13);
}

}  // namespace
}  // namespace rfm
