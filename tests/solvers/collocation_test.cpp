#include "solvers/collocation.hpp"

#include <gtest/gtest.h>

#include <Eigen/QR>
#include <Eigen/SVD>
#include <random>

#include "core/error.hpp"
#include "solvers/equations.hpp"
#include "solvers/sparse_qr.hpp"
#include "tests/solvers/sample_problems.hpp"

namespace rfm {
namespace {

using namespace test;

const Field x = x_coordinate(), y = y_coordinate();
const Field u = unknown_symbol(0, 2);

DomainRule rule_with(const Region& region, const Grid& grid, int inside, int cut) {
  QuadratureOptions options;
  options.inside_points = inside;
  options.cut_points = cut;
  return make_domain_rule(RegionEvaluator(region), grid, options);
}

// (A c − b)² is the sum over points of what least squares integrate, with the same rule.
TEST(Collocation, HasTheResidualsOfTheSolutionAtThePoints) {
  const Grid grid = triangle_grid(5);
  const DomainRule rule = rule_with(triangle(), grid, 2, 3);
  const std::vector<TensorProductSpace> spaces{TensorProductSpace(grid, 3, cells_in_region(rule))};
  const std::vector<Structure> structures{sin(y) + (1.0 + x) * Structure::undetermined()};
  const std::vector<Structure> changes{homogeneous_part(structures[0])};
  const std::vector<Form> forms{
      Form::least_squares({laplacian(u, 2) + x * u - exp(y), partial(u, 0)}, {1.0 + x * x, 3.0}),
      Form::least_squares({u - y}, {2.0}, {Contribution::Place::boundary, {0, 2}, {}})};
  Eigen::VectorXd coefficients(spaces[0].size());
  std::mt19937 generator(7);
  std::uniform_real_distribution<double> uniform(-1, 1);
  for (double& number : coefficients) number = uniform(generator);
  const Eigen::VectorXd zero = Eigen::VectorXd::Zero(coefficients.size());
  const CollocationSystem system =
      collocate(forms, solution_fields(structures, spaces, zero), changes, spaces, rule);
  const Field w = solution_fields(structures, spaces, coefficients)[0];
  const std::vector<Field> solution{w};
  const double expected =
      2 * integrate(forms[0].density(solution), rule) +
      2 * integrate(forms[1].density(solution), rule, {Contribution::Place::boundary, {0, 2}});
  EXPECT_NEAR((system.matrix * coefficients - system.right_hand_side).squaredNorm(), expected,
              1e-11 * expected);
}

// −Δu + u = f on the disk, u = g + ω Ψ with g equal to u on the circle only.
double error_of(int cells, int degree) {
  const Field exact = sin(2.0 * x + y) + x * y, omega = 1.0 - x * x - y * y;
  const Grid grid = Grid::with_square_cells({2, {-1.05, -1.1}, {1.1, 1.02}}, cells);
  const Region disk = circle({0, 0}, 1);
  const DomainRule rule = rule_with(disk, grid, std::max(2, degree - 1), degree);
  const std::vector<TensorProductSpace> spaces{
      TensorProductSpace(grid, degree, cells_in_region(rule, degree))};
  const std::vector<Structure> structures{exact + omega * cos(x) +
                                          omega * Structure::undetermined()};
  const std::vector<Form> forms{
      Form::least_squares({u - laplacian(u, 2) - (exact - laplacian(exact, 2))})};
  const NewtonSolution solution = solve_collocation(structures, spaces, forms, rule);
  EXPECT_EQ(solution.linear.method, LinearSolution::Method::qr);
  return norms(solution_fields(structures, spaces, solution.linear.coefficients)[0] - exact,
               rule_for(disk, grid, degree + 2))
      .l2;
}

TEST(Collocation, HasTheOrderOfLeastSquares) {
  // min(p + 1, 2 (p − 1)) in L2 by duality: 4 for p = 3, 5 for p = 4.
  EXPECT_NEAR(std::log2(error_of(10, 3) / error_of(20, 3)), 4, 0.5);
  EXPECT_NEAR(std::log2(error_of(10, 4) / error_of(20, 4)), 5, 0.5);
}

// One unknown y with residuals r(y), twice, so that there are more residuals than unknowns.
ResidualProblem of_one_unknown(std::function<double(double)> value,
                               std::function<double(double)> slope) {
  ResidualProblem problem;
  problem.size = 1;
  problem.at = [=](const Eigen::VectorXd& unknowns) {
    CollocationSystem system;
    system.right_hand_side = Eigen::VectorXd::Constant(2, -value(unknowns[0]));
    system.matrix.resize(2, 1);
    for (int row = 0; row < 2; ++row) system.matrix.insert(row, 0) = slope(unknowns[0]);
    return system;
  };
  return problem;
}

// Beyond |y| = 1.39 full steps for atan(y) = 0 lead farther and farther away.
TEST(NonlinearResiduals, ThatGrowAlongTheFullStepAreMetByShorterOnes) {
  const ResidualProblem problem =
      of_one_unknown([](double t) { return std::atan(t + 3); },
                     [](double t) { return 1 / (1 + (t + 3) * (t + 3)); });
  const NewtonSolution solution = solve_residuals(problem, {});
  EXPECT_NEAR(solution.linear.coefficients[0], -3, 1e-12);
  EXPECT_LT(solution.iterations[0].damping, 1);
  for (std::size_t i = 1; i < solution.iterations.size(); ++i)
    EXPECT_LE(solution.iterations[i].residual, solution.iterations[i - 1].residual);
}

TEST(NonlinearResiduals, ThatFallNoFurtherAreAnError) {
  // The slope has the wrong sign: no step descends.
  const ResidualProblem problem = of_one_unknown([](double t) { return std::exp(t) + 1; },
                                                 [](double t) { return -std::exp(t); });
  EXPECT_THROW(solve_residuals(problem, {}), ComputationError);
}

TEST(NonlinearResiduals, OfAStartThatIsTheSolutionAreKnownByTheLoad) {
  ResidualProblem problem = of_one_unknown([](double t) { return 1e-15 * (1 + t * t); },
                                           [](double t) { return 1 + 2e-15 * t; });
  problem.load = 1;
  const NewtonSolution solution = solve_residuals(problem, {});
  EXPECT_EQ(solution.linear.coefficients[0], 0);
}

// A second unknown that residuals hardly see is noise, however large.
TEST(NonlinearResiduals, AreNotJudgedByWhatTheyDoNotSee) {
  int calls = 0;
  ResidualProblem problem;
  problem.size = 2;
  problem.at = [&](const Eigen::VectorXd& c) {
    const double noise = ++calls % 2 == 0 ? 1e-13 : -1e-13;
    CollocationSystem system;
    system.right_hand_side =
        -Eigen::Vector3d(c[0] * c[0] - 1 + 2 * (c[0] - 1), 1e-14 * c[1] + noise, 0);
    system.matrix.resize(3, 2);
    system.matrix.insert(0, 0) = 2 * c[0] + 2;
    system.matrix.insert(1, 1) = 1e-14;
    return system;
  };
  const NewtonSolution solution = solve_residuals(problem, {});
  EXPECT_NEAR(solution.linear.coefficients[0], 1, 1e-14);
  EXPECT_LT(solution.iterations.size(), 9u);
}

TEST(SparseQr, IsTheDenseLeastSquaresSolution) {
  std::mt19937 generator(11);
  std::uniform_real_distribution<double> uniform(-1, 1);
  Eigen::MatrixXd dense(60, 25);
  for (double& number : dense.reshaped())
    number = uniform(generator) > 0.3 ? uniform(generator) : 0;
  dense.col(3) *= 1e12;
  const Eigen::VectorXd load = Eigen::VectorXd::LinSpaced(60, -1, 3);
  const Eigen::VectorXd expected = dense.colPivHouseholderQr().solve(load);
  const SparseMatrix sparse = dense.sparseView();
  const Eigen::VectorXd solution = least_squares_solution(sparse, load).solution;
  for (Eigen::Index i = 0; i < 25; ++i)
    EXPECT_NEAR(solution[i], expected[i], 1e-11 * std::abs(expected[i])) << i;
}

TEST(SparseQr, RefusesWhatDoesNotDetermineTheUnknowns) {
  Eigen::MatrixXd dense = Eigen::MatrixXd::Ones(5, 3);
  dense(0, 1) = 2;
  const SparseMatrix dependent = dense.sparseView();
  EXPECT_THROW(least_squares_solution(dependent, Eigen::VectorXd::Ones(5)), ComputationError);
  const SparseMatrix wide = Eigen::MatrixXd::Ones(2, 3).eval().sparseView();
  EXPECT_THROW(least_squares_solution(wide, Eigen::VectorXd::Ones(2)), ComputationError);
}

TEST(SparseQr, EstimatesTheSmallestSingularValueOfScaledColumns) {
  std::mt19937 generator(5);
  std::uniform_real_distribution<double> uniform(-1, 1);
  Eigen::MatrixXd dense(80, 30);
  for (double& number : dense.reshaped()) number = uniform(generator);
  dense.col(7) = dense.col(11) + 1e-5 * dense.col(3) + 1e-5 * dense.col(7);
  const Eigen::MatrixXd scaled = dense.colwise().normalized();
  const double exact = scaled.jacobiSvd().singularValues().minCoeff();
  EXPECT_LT(exact, 1e-4);
  dense.col(2) *= 1e9;
  const SparseMatrix sparse = dense.sparseView();
  const double found =
      least_squares_solution(sparse, Eigen::VectorXd::Ones(80)).smallest_singular_value;
  EXPECT_GE(found, 0.99 * exact);
  EXPECT_LE(found, 2 * exact);
}

// Aᵀ A of condition 1e16 against A of condition 1e8.
TEST(SparseQr, KeepsTheDigitsThatNormalEquationsLose) {
  const double small = 1e-8;
  Eigen::MatrixXd dense = Eigen::MatrixXd::Zero(4, 3);
  dense.row(0).setOnes();
  for (int i = 0; i < 3; ++i) dense(i + 1, i) = small;
  const Eigen::VectorXd exact = Eigen::Vector3d(1, -2, 3), load = dense * exact;
  const SparseMatrix sparse = dense.sparseView();
  EXPECT_LT((least_squares_solution(sparse, load).solution - exact).norm(), 1e-6);
  LinearSystem normal;
  normal.matrix =
      SparseMatrix((dense.transpose() * dense).eval().sparseView()).triangularView<Eigen::Lower>();
  normal.right_hand_side = dense.transpose() * load;
  EXPECT_THROW(solve(normal), ComputationError);
}

}  // namespace
}  // namespace rfm
