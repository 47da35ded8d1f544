#include "solution_structures/structure_formula.hpp"

#include <gmock/gmock.h>

#include <cmath>

#include "core/composition.hpp"
#include "core/error.hpp"
#include "core/evaluate.hpp"
#include "solution_structures/undetermined.hpp"
#include "solution_structures/verification.hpp"

namespace rfm {
namespace {

const Field x = x_coordinate(), y = y_coordinate();
const Field psi = undetermined_function(0), chi = undetermined_function(1);

// The terms and the formula are two descriptions of one function: the second knows nothing of the
// product rule of structures.
void expect_same(const Structure& structure) {
  const std::vector<Field> functions{random_function(2, 1000), random_function(2, 1001)};
  const Field by_terms = random_solution({structure}, 2, 1)[0];
  const Field by_formula = with_functions(structure.formula(), functions);
  for (const Point& at : {Point{0.3, -0.7}, Point{-0.2, 0.4}, Point{1.1, 0.6}}) {
    const double expected = value_at(by_formula, at);
    EXPECT_NEAR(value_at(by_terms, at), expected, 1e-12 * (1 + std::fabs(expected)));
  }
}

TEST(StructureFormula, EveryOperationOfTheAlgebraIsRead) {
  const Field omega = 1 - x * x - y * y;
  expect_same(structure_of(sin(x) + omega * psi));
  expect_same(structure_of(-psi * omega - chi / (2 + y * y)));
  expect_same(structure_of(partial(omega * partial(psi, 0), 1) - y * (x - chi)));
  expect_same(structure_of(select(apply(Operation::less, {x, 0.0}), psi + y, x * chi)));
  expect_same(structure_of(laplacian(omega * omega * psi, 2)));
}

TEST(StructureFormula, AlgebraOfStructuresKeepsFormulaAndTermsInStep) {
  const Structure a = Structure::undetermined(0), b = Structure::undetermined(1);
  const Field omega = 1 - x * x - y * y;
  expect_same(a + x * b);
  expect_same(y - a);
  expect_same(-(x * a - b));
  expect_same(partial(omega * a, 0) / (1 + x * x));
  expect_same(D(omega, omega * a - b, 2));
  expect_same(normalized(sin(x) * y, omega, 2) + omega * a);
  expect_same(select(apply(Operation::less, {x, 0.0}), a, y * b));
}

TEST(StructureFormula, WhatContainsNoUndeterminedFunctionStaysOneField) {
  const Structure structure = structure_of(sin(x) * y + x * psi);
  ASSERT_EQ(structure.terms().size(), 1u);
  EXPECT_TRUE(structure.terms()[0].coefficient.same_as(x));
  EXPECT_EQ(structure.derivative_order(), 0);
  EXPECT_EQ(structure.unknown_count(), 1);
}

TEST(StructureFormula, WhatIsNotAffineIsRefused) {
  EXPECT_THROW(structure_of(psi * chi), InvalidArgument);
  EXPECT_THROW(structure_of(sin(psi)), InvalidArgument);
  EXPECT_THROW(structure_of(pow(psi, 2)), InvalidArgument);
  EXPECT_THROW(structure_of(x / psi), InvalidArgument);
  EXPECT_THROW(structure_of(select(psi, x, y)), InvalidArgument);
  EXPECT_THROW(structure_of(partial(psi, 3)), InvalidArgument);
  EXPECT_THROW(structure_of(compose(psi, {x + 1, y, 0.0})), InvalidArgument);
}

}  // namespace
}  // namespace rfm
