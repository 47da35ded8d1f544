#include "solvers/greville_collocation.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <tuple>

#include "tests/solvers/sample_problems.hpp"

namespace rfm {
namespace {

using namespace test;

const Field x = x_coordinate(), y = y_coordinate();
const Field u = unknown_symbol(0, 2);

struct Errors {
  double l2 = 0, h1 = 0;
  LinearSolution::Method method = LinearSolution::Method::cholesky;
};

// −Δu + u = f on a disk, u = g + ω Ψ with g equal to u on the circle only; or with the value as a
// residual on the circle.
Errors errors_of(int cells, int degree, bool weakly = false) {
  const Field exact = sin(2.0 * x + y) + x * y, omega = 1.0 - x * x - y * y;
  const Grid grid = Grid::with_square_cells({2, {-1.05, -1.1}, {1.1, 1.02}}, cells);
  const Region disk = circle({0, 0}, 1);
  const DomainRule rule = rule_for(disk, grid, degree);
  const std::vector<TensorProductSpace> spaces{
      TensorProductSpace(grid, degree, cells_in_region(rule, degree))};
  const std::vector<Structure> structures{weakly ? Structure::undetermined()
                                                 : exact + omega * cos(x) +
                                                       omega * Structure::undetermined()};
  std::vector<Form> forms{
      Form::least_squares({u - laplacian(u, 2) - (exact - laplacian(exact, 2))})};
  if (weakly)
    forms.push_back(Form::least_squares({u - exact}, {std::pow(grid.spacing(0), -3)},
                                        {Contribution::Place::boundary, {}, {}}));
  const NewtonSolution solution =
      solve_greville(structures, spaces, forms, RegionEvaluator(disk), rule);
  const auto errors =
      norms(solution_fields(structures, spaces, solution.linear.coefficients)[0] - exact,
            rule_for(disk, grid, degree + 2));
  return {errors.l2, errors.h1_seminorm, solution.linear.method};
}

TEST(GrevilleCollocation, HasTheOrderOfTheDegreeIfEvenAndOneLessIfOdd) {
  // Over two halvings: single grids differ by how points happen to lie at the boundary.
  for (const auto& [degree, order] : {std::pair{2, 2}, {3, 2}, {4, 4}, {5, 4}}) {
    const Errors coarse = errors_of(16, degree), fine = errors_of(64, degree);
    EXPECT_EQ(fine.method, LinearSolution::Method::lu);
    EXPECT_NEAR(std::log2(coarse.l2 / fine.l2) / 2, order, 0.5) << degree;
    EXPECT_GT(std::log2(coarse.h1 / fine.h1) / 2, order - 0.7) << degree;
  }
}

// −u″ + u = f on (0, 1), whose ends cut the first and the last cell at the same places on every
// grid: what these places change is gone.
Errors errors_on_a_line(int cells, int degree) {
  const double h = 1.0 / (cells - 1);
  const Grid grid({1, {-0.8 * h}, {1 + 0.2 * h}}, {cells, 1, 1});
  const DomainRule rule = rule_for(unit_box(1), grid, degree);
  const std::vector<TensorProductSpace> spaces{
      TensorProductSpace(grid, degree, cells_in_region(rule, degree))};
  const Field w = unknown_symbol(0, 1), exact = sin(2.0 * x + 0.3) * exp(x);
  const Field omega = unit_box_weight(1);
  const std::vector<Structure> structures{exact + omega * cos(2.0 * x) +
                                          omega * Structure::undetermined()};
  const std::vector<Form> forms{
      Form::least_squares({w - laplacian(w, 1) - (exact - laplacian(exact, 1))})};
  const NewtonSolution solution =
      solve_greville(structures, spaces, forms, RegionEvaluator(unit_box(1)), rule);
  const auto errors =
      norms(solution_fields(structures, spaces, solution.linear.coefficients)[0] - exact,
            rule_for(unit_box(1), grid, degree + 2));
  return {errors.l2, errors.h1_seminorm, solution.linear.method};
}

TEST(GrevilleCollocation, HasItsOrderToATenthWhereCellsAreCutAlike) {
  for (const auto& [degree, cells, order] :
       {std::tuple{2, 128, 2}, {3, 128, 2}, {4, 128, 4}, {5, 64, 4}}) {
    const Errors coarse = errors_on_a_line(cells, degree),
                 fine = errors_on_a_line(2 * cells, degree);
    EXPECT_NEAR(std::log2(coarse.l2 / fine.l2), order, 0.1) << degree;
    EXPECT_NEAR(std::log2(coarse.h1 / fine.h1), order, 0.1) << degree;
  }
}

TEST(GrevilleCollocation, HasAShareOfOrderTwoAboveTheDegreeFromAttachedSplines) {
  // On coarse grids the boundary has all of the error, which falls faster than that inside: the
  // reason why orders of degree 4 lie between 4 and 6.
  const double order = std::log2(errors_on_a_line(8, 4).l2 / errors_on_a_line(16, 4).l2);
  EXPECT_NEAR(order, 6, 0.7);
}

TEST(GrevilleCollocation, IsLeastSquaresWhereTheBoundaryHasResiduals) {
  const Errors coarse = errors_of(16, 4, true), fine = errors_of(64, 4, true);
  EXPECT_EQ(fine.method, LinearSolution::Method::qr);
  EXPECT_NEAR(std::log2(coarse.l2 / fine.l2) / 2, 4.3, 0.8);
}

TEST(GrevilleCollocation, FindsPolynomialsOfItsSpace) {
  // u = (1 − r²)(1 + x y²) is ω times a polynomial of degree 3.
  const Field omega = 1.0 - x * x - y * y, exact = omega * (1.0 + x * y * y);
  const Grid grid = Grid::with_square_cells({2, {-1, -1}, {1, 1}}, 9);
  const Region disk = circle({0, 0}, 1);
  const DomainRule rule = rule_for(disk, grid, 3);
  const std::vector<TensorProductSpace> spaces{
      TensorProductSpace(grid, 3, cells_in_region(rule, 3))};
  const std::vector<Structure> structures{omega * Structure::undetermined()};
  // Nonlinear: −Δu + u³ = f.
  const std::vector<Form> forms{
      Form::least_squares({pow(u, 3) - laplacian(u, 2) - (pow(exact, 3) - laplacian(exact, 2))})};
  const NewtonSolution solution =
      solve_greville(structures, spaces, forms, RegionEvaluator(disk), rule);
  EXPECT_GT(solution.iterations.size(), 2u);
  EXPECT_LT(
      norms(solution_fields(structures, spaces, solution.linear.coefficients)[0] - exact, rule).l2,
      1e-11);
}

TEST(GrevilleCollocation, FindsPolynomialsOnCellsOfDifferentWidths) {
  // u = (1 − r²)(1 + x y²) is ω times a polynomial of degree 3.
  const Field omega = 1.0 - x * x - y * y, exact = omega * (1.0 + x * y * y);
  std::vector<double> lines[2];
  for (int axis = 0; axis < 2; ++axis)
    for (int i = 0; i <= 10; ++i)
      lines[axis].push_back(-1.05 + 0.21 * i + 0.06 * std::sin((2.3 + axis) * i));
  const Grid grid = Grid::with_lines(lines);
  const Region disk = circle({0, 0}, 1);
  const DomainRule rule = rule_for(disk, grid, 3);
  const std::vector<TensorProductSpace> spaces{
      TensorProductSpace(grid, 3, cells_in_region(rule, 3))};
  const std::vector<Structure> structures{omega * Structure::undetermined()};
  const std::vector<Form> forms{
      Form::least_squares({u - laplacian(u, 2) - (exact - laplacian(exact, 2))})};
  const NewtonSolution solution =
      solve_greville(structures, spaces, forms, RegionEvaluator(disk), rule);
  EXPECT_EQ(solution.linear.method, LinearSolution::Method::lu);
  EXPECT_LT(
      norms(solution_fields(structures, spaces, solution.linear.coefficients)[0] - exact, rule).l2,
      1e-11);
}

}  // namespace
}  // namespace rfm
