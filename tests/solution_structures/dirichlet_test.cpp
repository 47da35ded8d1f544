#include "solution_structures/dirichlet.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "core/evaluate.hpp"
#include "core/primitives.hpp"

using namespace rfm;

namespace {

const Field x = x_coordinate(), y = y_coordinate();

TEST(Dirichlet, TakesItsDataOnTheBoundaryWhateverTheUndeterminedFunction) {
  const Field g = 2 + sin(x) * y, omega = 1 - x * x - y * y;
  const Structure u = dirichlet(g, omega);
  for (const Field& psi : {Field(7.0), 1e3 * exp(x) * y, cos(5 * x * y)}) {
    Field value = u.inhomogeneous();
    for (const auto& term : u.terms()) value = value + term.coefficient * psi;
    for (const double t : {0.1, 1.3, 2.9, 4.4})
      EXPECT_NEAR(value_at(value, {std::cos(t), std::sin(t), 0}),
                  2 + std::sin(std::cos(t)) * std::sin(t), 1e-12);
  }
}

TEST(Dirichlet, IsDataPlusWeightTimesUndeterminedFunctionInside) {
  // The sign of the second term matters inside, where the boundary test cannot see it.
  const Structure u = dirichlet(3.0, x);
  ASSERT_EQ(u.terms().size(), 1u);
  EXPECT_EQ(value_at(u.terms()[0].coefficient, {0.25, 0, 0}), 0.25);
  EXPECT_EQ(value_at(u.inhomogeneous(), {0.25, 0, 0}), 3.0);
}

}  // namespace
