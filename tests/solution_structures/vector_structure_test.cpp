#include "solution_structures/vector_structure.hpp"

#include <gmock/gmock.h>

#include "core/derivative_fields.hpp"
#include "core/error.hpp"
#include "core/evaluate.hpp"
#include "solution_structures/verification.hpp"

namespace rfm {
namespace {

const Field x = x_coordinate(), y = y_coordinate(), omega = 1 - x * x - 2 * y * y;
const std::vector<Structure> psi = undetermined_vector(2);
const std::vector<Structure> u = omega * psi + structures({sin(x), x* y});

void expect_equal(const std::vector<Structure>& structures, const std::vector<Field>& expected) {
  const std::vector<Field> values = random_solution(structures, 2, 1);
  ASSERT_EQ(values.size(), expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i)
    EXPECT_NEAR(value_at(values[i], {0.3, -0.7}), value_at(expected[i], {0.3, -0.7}), 1e-12);
}

TEST(VectorStructure, OperationsAreThoseOfItsComponents) {
  const std::vector<Field> v = random_solution(u, 2, 1), psi_v = random_solution(psi, 2, 1);
  expect_equal(u + psi, {v[0] + psi_v[0], v[1] + psi_v[1]});
  expect_equal(u - psi, {v[0] - psi_v[0], v[1] - psi_v[1]});
  expect_equal({divergence(u)}, {divergence(v)});
  expect_equal({dot({y, x}, u)}, {y * v[0] + x * v[1]});
  expect_equal(std::vector<Field>{x, y} * u[0], {x * v[0], y * v[0]});
  expect_equal(D(omega, u, 2),
               {inward_derivative(v[0], omega, 2), inward_derivative(v[1], omega, 2)});
}

TEST(VectorStructure, ComponentsHaveUndeterminedFunctionsOfTheirOwn) {
  EXPECT_EQ(undetermined_vector(3, 2)[1].terms()[0].unknown, 3);
  EXPECT_EQ(u[0].unknown_count(), 1);
  EXPECT_EQ(u[1].unknown_count(), 2);
}

TEST(VectorStructure, DifferentNumbersOfComponentsAreRefused) {
  EXPECT_THROW(u + undetermined_vector(3), InvalidArgument);
  EXPECT_THROW(u - undetermined_vector(1), InvalidArgument);
  EXPECT_THROW(dot({x}, u), InvalidArgument);
}

}  // namespace
}  // namespace rfm
