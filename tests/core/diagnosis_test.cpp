#include "core/diagnosis.hpp"

#include <gtest/gtest.h>

using namespace rfm;

namespace {

const Field x = x_coordinate(), y = y_coordinate();

TEST(Diagnosis, NothingIsSaidOfFiniteValues) { EXPECT_EQ(diagnose(1 / x, {2, 0}, 2), ""); }

TEST(Diagnosis, InnermostFailingOperationIsNamedWithItsArguments) {
  EXPECT_EQ(diagnose(exp(1 + sqrt(x - 1)) * y, {0.75, 3}, 2), "sqrt(-0.25)");
  EXPECT_EQ(diagnose(y + 1 / (x - 2), {2, 0}, 2), "1 / 0");
  EXPECT_EQ(diagnose(log(x) * 0.5, {0, 0}, 2), "log(0)");
  EXPECT_EQ(diagnose(pow(x, -2.0), {0, 0}, 2), "0^-2");
}

TEST(Diagnosis, BranchesNotTakenAreNotBlamed) {
  const Field inside = apply(Operation::less, {x, 1.0});
  EXPECT_EQ(diagnose(select(inside, log(x), sqrt(x - 3)), {-0.5, 0}, 2), "log(-0.5)");
}

}  // namespace
