#include "solvers/energy.hpp"

#include <gmock/gmock.h>

#include "core/error.hpp"
#include "tests/solvers/sample_problems.hpp"

namespace rfm {
namespace {

using namespace test;
using Place = Contribution::Place;
const Field x = x_coordinate(), y = y_coordinate();

// The unit square with the sides left, right, bottom, top as primitives 0 … 3.
const DomainRule& square_rule() {
  static const DomainRule rule = rule_for(unit_box(2), Grid({2, {0, 0}, {1, 1}}, {3, 3, 1}), 3);
  return rule;
}

TEST(Energy, IsHalfTheStiffnessLessTheLoad) {
  // u = x² y: ∫ |∇u|² = ∫ 4x²y² + x⁴ = 4/9 + 1/5, ∫ u² = 1/15, ∫ y u = 1/9.
  QuadraticEnergy volume = diffusion(2, 3.0, 5.0, y);
  const Field u[] = {x * x * y};
  EXPECT_NEAR(energy({volume}, u, square_rule()),
              0.5 * (3 * (4.0 / 9 + 1.0 / 5) + 5.0 / 15) - 1.0 / 9, 1e-15);
}

TEST(Energy, OfTwoSlotsCountsTheirProductOnce) {
  QuadraticEnergy volume;  // u_0 ∂u_1/∂y with u = (x, x y²): ∫ x · 2 x y = 1/3
  volume.add_stiffness(value(0), slope(1, 1), 1.0);
  const Field u[] = {x, x * y * y};
  EXPECT_NEAR(energy({volume}, u, square_rule()), 1.0 / 3, 1e-15);
}

TEST(Energy, OnTheBoundaryKnowsTheNormalAndTheChosenPrimitives) {
  QuadraticEnergy boundary;  // −n_x u on the right and the top side: −∫ y dy there, u = x y
  boundary.add_load(value(), Coefficient::normal(0));
  const Field u[] = {x * y};
  EXPECT_NEAR(energy({boundary, Place::boundary, {1, 3}}, u, square_rule()), -0.5, 1e-15);
  EXPECT_NEAR(energy({boundary, Place::boundary, {3}}, u, square_rule()), 0, 1e-15);
}

TEST(Energy, LeavesOutWhereAContributionDoesNotCountEvenIfItIsUndefinedThere) {
  // √(y − 2/3)′s square on the upper third of the grid's cells: ∫ over [0, 1] × [2/3, 1] is 1/18.
  QuadraticEnergy volume;
  volume.add_stiffness(value(), value(), 2.0);
  const Field u[] = {sqrt(y - 2.0 / 3)};
  EXPECT_NEAR(energy({volume, Place::volume, {}, y - 2.0 / 3}, u, square_rule()), 1.0 / 18, 1e-15);
}

TEST(Energy, RefusesAComponentThatTheSolutionDoesNotHave) {
  QuadraticEnergy volume;
  volume.add_load(value(1), 1.0);
  const Field u[] = {x};
  EXPECT_THROW(energy({volume}, u, square_rule()), InvalidArgument);
}

}  // namespace
}  // namespace rfm
