#include "solvers/general_factorization.hpp"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <random>

#include "core/error.hpp"
#include "solvers/equilibration.hpp"
#include "tests/solvers/sample_problems.hpp"

namespace rfm {
namespace {

using namespace test;

// Dominated by nothing: pivoting is needed.
SparseMatrix random_matrix(int size, unsigned seed) {
  std::mt19937 generator(seed);
  std::uniform_real_distribution<double> uniform(-1, 1);
  std::uniform_int_distribution<int> place(0, size - 1);
  std::vector<Eigen::Triplet<double, std::int64_t>> entries;
  for (int i = 0; i < size; ++i) {
    entries.emplace_back(i, (i + 1) % size, uniform(generator));
    for (int k = 0; k < 5; ++k) entries.emplace_back(i, place(generator), uniform(generator));
  }
  SparseMatrix matrix(size, size);
  matrix.setFromTriplets(entries.begin(), entries.end());
  return matrix;
}

TEST(GeneralFactorization, SolvesAsADenseOneDoes) {
  const SparseMatrix matrix = random_matrix(150, 3);
  const Eigen::VectorXd load = Eigen::VectorXd::LinSpaced(150, -1, 2);
  const GeneralFactorization factorization(matrix);
  const Eigen::VectorXd expected = Eigen::MatrixXd(matrix).partialPivLu().solve(load);
  EXPECT_LT((factorization.solve(load) - expected).norm(), 1e-11 * expected.norm());
}

TEST(GeneralFactorization, KnowsTheSmallestSingularValueUpToAFactor) {
  SparseMatrix matrix(3, 3);
  matrix.insert(0, 1) = 2;
  matrix.insert(1, 2) = 1e-5;
  matrix.insert(2, 0) = 1;
  matrix.makeCompressed();
  EXPECT_NEAR(GeneralFactorization(matrix).smallest_singular_value(), 1e-5, 1e-6);
}

TEST(GeneralFactorization, RefusesSingularMatrices) {
  SparseMatrix matrix = random_matrix(40, 5);
  Eigen::MatrixXd dense(matrix);
  dense.row(7) = dense.row(3) - dense.row(20);
  matrix = dense.sparseView();
  EXPECT_THROW(GeneralFactorization{matrix}, ComputationError);
}

TEST(Equilibration, BringsTheLargestEntriesOfRowsAndColumnsNearOne) {
  SparseMatrix matrix = random_matrix(60, 9);
  for (Eigen::Index column = 0; column < 60; ++column)
    for (SparseMatrix::InnerIterator entry(matrix, column); entry; ++entry)
      entry.valueRef() *= std::pow(10.0, 40 * std::sin(double(entry.row()))) *
                          std::pow(10.0, -30 * std::cos(double(column)));
  const Equilibration scaling(matrix);
  EXPECT_EQ(scaling.dropped, 0);
  const Eigen::MatrixXd scaled = Eigen::MatrixXd(scaling.apply(matrix)).cwiseAbs();
  for (int i = 0; i < 60; ++i) {
    EXPECT_NEAR(scaled.row(i).maxCoeff(), 1, 0.6) << i;
    EXPECT_NEAR(scaled.col(i).maxCoeff(), 1, 0.6) << i;
  }
}

TEST(LinearSolver, SolvesSaddlePointsWhoseDiagonalVanishes) {
  // ½ x² + ½ y² + λ (x + y − 2): x = y = 1, λ = −1.
  LinearSystem system;
  system.matrix.resize(3, 3);
  system.matrix.insert(0, 0) = 1;
  system.matrix.insert(1, 1) = 1;
  system.matrix.insert(2, 0) = 1;
  system.matrix.insert(2, 1) = 1;
  system.matrix.makeCompressed();
  system.right_hand_side.resize(3);
  system.right_hand_side << 0, 0, 2;
  const LinearSolution solution = solve(system);
  EXPECT_EQ(solution.method, LinearSolution::Method::lu);
  EXPECT_NEAR(solution.coefficients[0], 1, 1e-14);
  EXPECT_NEAR(solution.coefficients[1], 1, 1e-14);
  EXPECT_NEAR(solution.coefficients[2], -1, 1e-14);
}

// ∫ (ε ∇u·∇v + b·∇u v) with two unknowns of different degree, one in the equation of the other.
TEST(Assembly, OfCouplingsIsTheBilinearFormOfTrialAndTestFunctions) {
  const Field x = x_coordinate(), y = y_coordinate();
  const Grid grid = triangle_grid(5);
  const DomainRule rule = rule_for(triangle(), grid, 3);
  const std::vector<std::uint8_t> cells = cells_in_region(rule);
  const std::vector<TensorProductSpace> spaces{TensorProductSpace(grid, 3, cells),
                                               TensorProductSpace(grid, 2, cells)};
  const std::vector<Structure> structures{(1.0 + x) * Structure::undetermined(0),
                                          exp(y) * Structure::undetermined(1)};
  Contribution part{diffusion(2, 0.1, 0.0, 0.0)};
  part.couplings = {{value(0), slope(0, 0), 1.0 + y},
                    {value(0), slope(1, 1), x},
                    {slope(0, 1), value(0), 3.0},
                    {value(1), value(1), 2.0}};
  const LinearSystem system = assemble(structures, spaces, std::span(&part, 1), rule);
  ASSERT_FALSE(system.symmetric);
  std::mt19937 generator(4);
  std::uniform_real_distribution<double> uniform(-1, 1);
  Eigen::VectorXd trial(system.size()), test(system.size());
  for (double& number : trial) number = uniform(generator);
  for (double& number : test) number = uniform(generator);
  const std::vector<Field> u = solution_fields(structures, spaces, trial);
  const std::vector<Field> v = solution_fields(structures, spaces, test);
  const Field density =
      0.1 * (partial(u[0], 0) * partial(v[0], 0) + partial(u[0], 1) * partial(v[0], 1)) +
      (1.0 + y) * partial(u[0], 0) * v[0] + x * partial(u[1], 1) * v[0] +
      3.0 * u[0] * partial(v[1], 0) + 2.0 * u[1] * v[1];
  const double expected = integrate(density, rule);
  EXPECT_NEAR(test.dot(system.matrix * trial), expected, 1e-11 * std::abs(expected));
}

}  // namespace
}  // namespace rfm
