#include "solvers/solution.hpp"

#include <gmock/gmock.h>

#include "core/bspline.hpp"
#include "core/error.hpp"
#include "core/evaluate.hpp"

namespace rfm {
namespace {

const Field x = x_coordinate(), y = y_coordinate();
const Grid line({1, {0}, {2}}, {2, 1, 1});

TEST(Solution, PutsTheUndeterminedFunctionsIntoTheStructure) {
  // Linear splines: Ψ0 interpolates 1, 3, 2 at 0, 1, 2; Ψ1 (degree 2) is constant 5.
  const std::vector<TensorProductSpace> spaces{{line, 1}, {line, 2}};
  Eigen::VectorXd coefficients(3 + 4);
  coefficients << 1, 3, 2, 5, 5, 5, 5;
  const std::vector<Structure> structures{
      x + x * x * Structure::undetermined(0) + partial(Structure::undetermined(0), 0),
      Structure::undetermined(1) - 2.0 * Structure::undetermined(0)};
  const std::vector<Field> u = solution_fields(structures, spaces, coefficients);
  ASSERT_EQ(u.size(), 2u);
  EXPECT_DOUBLE_EQ(value_at(u[0], {0.5}), 0.5 + 0.25 * 2 + 2);    // Ψ0(½) = 2, slope 2
  EXPECT_DOUBLE_EQ(value_at(u[0], {1.5}), 1.5 + 2.25 * 2.5 - 1);  // Ψ0 = 2.5, slope −1
  EXPECT_DOUBLE_EQ(value_at(u[1], {1.5}), 5 - 2 * 2.5);
  // It is a field: ∂u₀/∂x = 1 + 2x Ψ0 + x² Ψ0′ inside a cell.
  EXPECT_DOUBLE_EQ(value_at(partial(u[0], 0), {0.5}), 1 + 2 + 0.25 * 2);
}

TEST(Solution, SplinesThatWereLeftOutAreZero) {
  const std::vector<std::uint8_t> cells{0, 1};
  const TensorProductSpace space(line, 1, cells);
  const std::vector<Field> psi =
      undetermined_functions(std::span(&space, 1), Eigen::Vector2d(4, 6));
  EXPECT_DOUBLE_EQ(value_at(psi[0], {1.5}), 5);
  EXPECT_DOUBLE_EQ(value_at(psi[0], {0.5}), 2);
}

TEST(Solution, WrongNumbersAreRefused) {
  const TensorProductSpace space(line, 1);
  EXPECT_THROW(undetermined_functions(std::span(&space, 1), Eigen::VectorXd::Zero(4)),
               InvalidArgument);
  EXPECT_THROW(solution_field(Structure::undetermined(1), std::vector<Field>{x}), InvalidArgument);
}

}  // namespace
}  // namespace rfm
