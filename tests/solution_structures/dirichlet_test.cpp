#include "solution_structures/dirichlet.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <random>

#include "core/bounding_box.hpp"
#include "core/evaluate.hpp"
#include "core/primitives.hpp"
#include "core/weight.hpp"

namespace rfm {
namespace {

const Field x = x_coordinate(), y = y_coordinate();

// u = g + Σ a ∂^β Ψ with a random polynomial for Ψ.
Field with_random_unknown(const Structure& structure, unsigned seed) {
  std::mt19937 generator(seed);
  std::uniform_real_distribution<double> uniform(-1, 1);
  Field unknown = 0.0;
  for (int i = 0; i <= 3; ++i)
    for (int j = 0; i + j <= 3; ++j) unknown = unknown + uniform(generator) * pow(x, i) * pow(y, j);
  Field u = structure.inhomogeneous();
  for (const auto& term : structure.terms())
    u = u + term.coefficient * partial(unknown, term.derivative);
  return u;
}

TEST(Dirichlet, StructureEqualsItsDataOnTheBoundaryForAnyUnknown) {
  const Region ring = circle({0, 0}, 1) - circle({0.2, 0.1}, 0.4);
  const RegionEvaluator evaluator(ring);
  const Field g = sin(3 * x) + x * y;
  const Structure structure = dirichlet(g, weight(evaluator, bounding_box(evaluator)).function);
  for (unsigned seed = 1; seed <= 5; ++seed) {
    const Field u = with_random_unknown(structure, seed);
    for (double t = 0; t < 6.28; t += 0.1) {
      const Point outer{std::cos(t), std::sin(t)};
      const Point inner{0.2 + 0.4 * std::cos(t), 0.1 + 0.4 * std::sin(t)};
      EXPECT_NEAR(value_at(u, outer), value_at(g, outer), 2e-15);
      EXPECT_NEAR(value_at(u, inner), value_at(g, inner), 2e-15);
    }
    // Inside it is free to differ.
    EXPECT_GT(std::fabs(value_at(u - g, {-0.5, -0.3})), 1e-3);
  }
}

TEST(Dirichlet, StructureIsTheDatumAndOmegaTimesTheUnknown) {
  // The sign of the second term is not seen on the boundary.
  const Field omega = 1 - y;
  const Structure structure = dirichlet(x, omega);
  EXPECT_TRUE(structure.inhomogeneous().same_as(x));
  ASSERT_EQ(structure.terms().size(), 1u);
  EXPECT_EQ(structure.terms()[0].unknown, 0);
  EXPECT_TRUE(structure.terms()[0].coefficient.same_as(omega));
  EXPECT_EQ(structure.derivative_order(), 0);
}

}  // namespace
}  // namespace rfm
