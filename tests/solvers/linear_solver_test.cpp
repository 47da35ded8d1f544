#include "solvers/linear_solver.hpp"

#include <gmock/gmock.h>

#include <Eigen/Dense>
#include <numbers>
#include <random>

#include "core/error.hpp"
#include "solvers/symmetric_factorization.hpp"

namespace rfm {
namespace {

using testing::HasSubstr;
using testing::ThrowsMessage;

// The five-point Laplacian on an n × n grid plus `shift`: eigenvalues between shift and shift + 8.
LinearSystem laplacian(int n, double shift = 0) {
  std::vector<Eigen::Triplet<double, std::int64_t>> entries;
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < n; ++i) {
      const int row = i + n * j;
      entries.emplace_back(row, row, 4 + shift);
      if (i + 1 < n) entries.emplace_back(row + 1, row, -1.0);
      if (j + 1 < n) entries.emplace_back(row + n, row, -1.0);
    }
  LinearSystem system;
  system.matrix.resize(n * n, n * n);
  system.matrix.setFromTriplets(entries.begin(), entries.end());
  system.right_hand_side.resize(n * n);
  for (int i = 0; i < n * n; ++i) system.right_hand_side[i] = std::sin(i + 1.0);
  return system;
}

// The graph Laplacian of a ring: constants are in its kernel.
LinearSystem ring(int n) {
  std::vector<Eigen::Triplet<double, std::int64_t>> entries;
  for (int i = 0; i < n; ++i) entries.emplace_back(i, i, 2.0);
  for (int i = 0; i + 1 < n; ++i) entries.emplace_back(i + 1, i, -1.0);
  entries.emplace_back(n - 1, 0, -1.0);
  LinearSystem system;
  system.matrix.resize(n, n);
  system.matrix.setFromTriplets(entries.begin(), entries.end());
  system.right_hand_side = Eigen::VectorXd::Zero(n);
  return system;
}

double error_of(const LinearSystem& system, const LinearSolution& solution) {
  const Eigen::MatrixXd lower(system.matrix);
  const Eigen::MatrixXd full = lower.selfadjointView<Eigen::Lower>();
  const Eigen::VectorXd exact = full.partialPivLu().solve(system.right_hand_side);
  return (solution.coefficients - exact).norm() / exact.norm();
}

class EveryMethod : public testing::TestWithParam<std::tuple<LinearSolverOptions::Method, int>> {};
INSTANTIATE_TEST_SUITE_P(
    LinearSolver, EveryMethod,
    testing::Combine(testing::Values(LinearSolverOptions::Method::automatic,
                                     LinearSolverOptions::Method::direct,
                                     LinearSolverOptions::Method::conjugate_gradient),
                     testing::Values(2, 3)));

TEST_P(EveryMethod, SolvesAPositiveDefiniteSystem) {
  LinearSolverOptions options;
  std::tie(options.method, options.dimension) = GetParam();
  const LinearSystem system = laplacian(15);
  const LinearSolution solution = solve(system, options);
  EXPECT_LT(error_of(system, solution), 1e-11);
  EXPECT_LT(solution.relative_residual, 1e-12);
  EXPECT_EQ(solution.dropped, 0);
  EXPECT_EQ(solution.method == LinearSolution::Method::conjugate_gradient,
            options.method == LinearSolverOptions::Method::conjugate_gradient);
}

TEST(LinearSolver, ChoosesConjugateGradientsForManyUnknownsInSpace) {
  LinearSolverOptions options;
  options.dimension = 3;
  options.largest_direct_3d = 100;
  EXPECT_EQ(solve(laplacian(15), options).method, LinearSolution::Method::conjugate_gradient);
  EXPECT_EQ(solve(laplacian(10), options).method, LinearSolution::Method::cholesky);
  options.dimension = 2;
  EXPECT_EQ(solve(laplacian(15), options).method, LinearSolution::Method::cholesky);
}

TEST_P(EveryMethod, IsInvariantUnderTheScaleOfBasisFunctions) {
  LinearSolverOptions options;
  std::tie(options.method, options.dimension) = GetParam();
  const LinearSystem system = laplacian(12);
  const LinearSolution reference = solve(system, options);
  LinearSystem scaled = system;
  std::mt19937 generator(5);
  std::uniform_real_distribution<double> exponent(-100, 0);
  Eigen::VectorXd factors(system.size());  // basis function i multiplied by factors[i]
  for (double& factor : factors) factor = std::pow(10, 0.5 * exponent(generator));
  for (Eigen::Index column = 0; column < system.size(); ++column) {
    for (SparseMatrix::InnerIterator entry(scaled.matrix, column); entry; ++entry)
      entry.valueRef() *= factors[entry.row()] * factors[column];
    scaled.right_hand_side[column] *= factors[column];
  }
  const LinearSolution solution = solve(scaled, options);
  EXPECT_EQ(solution.dropped, 0);
  const Eigen::VectorXd back = solution.coefficients.cwiseProduct(factors);
  EXPECT_LT((back - reference.coefficients).norm(), 1e-11 * reference.coefficients.norm());
}

TEST_P(EveryMethod, DropsSplinesWithoutEnergyAndCountsThem) {
  LinearSolverOptions options;
  std::tie(options.method, options.dimension) = GetParam();
  LinearSystem system = laplacian(5);
  for (const int dropped : {3, 17}) {
    for (Eigen::Index column = 0; column < system.size(); ++column)
      for (SparseMatrix::InnerIterator entry(system.matrix, column); entry; ++entry)
        if (entry.row() == dropped || column == dropped)
          entry.valueRef() = entry.row() == column && dropped == 3 ? 1e-301 : 0;
    system.right_hand_side[dropped] = 0;
  }
  const LinearSolution solution = solve(system, options);
  EXPECT_EQ(solution.dropped, 2);
  EXPECT_EQ(solution.coefficients[3], 0);
  EXPECT_EQ(solution.coefficients[17], 0);
  EXPECT_LT(solution.relative_residual, 1e-12);
  EXPECT_NE(solution.coefficients[16], 0);
}

TEST(LinearSolver, ReportsTheResidualOfTheScaledSystem) {
  LinearSolverOptions options;
  options.method = LinearSolverOptions::Method::conjugate_gradient;
  options.tolerance = 1e-4;
  const LinearSystem system = laplacian(25);
  const LinearSolution solution = solve(system, options);
  // The diagonal is 4 throughout: scaling does not change relative residuals.
  const Eigen::VectorXd residual =
      system.right_hand_side -
      system.matrix.selfadjointView<Eigen::Lower>() * solution.coefficients;
  EXPECT_NEAR(solution.relative_residual, residual.norm() / system.right_hand_side.norm(), 1e-14);
  EXPECT_GT(solution.relative_residual, 1e-6);
  EXPECT_LT(solution.relative_residual, 1e-4);
}

TEST(LinearSolver, FallsBackToLdltForIndefiniteSystems) {
  const LinearSystem system = laplacian(12, -0.5);  // some eigenvalues are negative
  const LinearSolution solution = solve(system);
  EXPECT_EQ(solution.method, LinearSolution::Method::ldlt);
  EXPECT_LT(error_of(system, solution), 1e-11);
}

TEST(LinearSolver, RefinementDoesNotWorsenTheResidual) {
  LinearSolverOptions once, never;
  never.refinement_steps = 0;
  const LinearSystem system = laplacian(40, -8e-3);
  EXPECT_LE(solve(system, once).relative_residual, solve(system, never).relative_residual);
}

TEST(LinearSolver, SaysThatASingularSystemDoesNotDetermineItsSolution) {
  for (const int n : {3, 8, 50, 1001, 20'000})
    EXPECT_THAT([&] { solve(ring(n)); },
                ThrowsMessage<ComputationError>(HasSubstr("does not determine its solution")))
        << n;
}

TEST(LinearSolver, ConjugateGradientsThatDoNotConvergeSaySo) {
  LinearSolverOptions options;
  options.method = LinearSolverOptions::Method::conjugate_gradient;
  options.largest_iteration_count = 3;
  EXPECT_THAT([&] { solve(laplacian(20), options); },
              ThrowsMessage<ComputationError>(HasSubstr("did not converge after 3 iterations")));
}

TEST(LinearSolver, FactorisesWhereConjugateGradientsFail) {
  LinearSolverOptions options;
  options.dimension = 3;
  options.largest_direct_3d = 100;
  const LinearSystem system = laplacian(12, -0.5);
  const LinearSolution solution = solve(system, options);
  EXPECT_EQ(solution.method, LinearSolution::Method::ldlt);
  EXPECT_GT(solution.iterations, 0);
  EXPECT_LT(error_of(system, solution), 1e-11);
  options.method = LinearSolverOptions::Method::conjugate_gradient;
  EXPECT_THAT([&] { solve(system, options); },
              ThrowsMessage<ComputationError>(HasSubstr("without positive energy")));
}

TEST(LinearSolver, NumbersThatAreNotFiniteAreRefused) {
  LinearSystem system = laplacian(4);
  system.right_hand_side[2] = NAN;
  EXPECT_THROW(solve(system), ComputationError);
  system = laplacian(4);
  system.matrix.coeffRef(1, 0) = NAN;
  EXPECT_THROW(solve(system), ComputationError);
  system = laplacian(4);
  system.matrix.coeffRef(1, 1) = INFINITY;
  EXPECT_THROW(solve(system), ComputationError);
}

TEST(LinearSolver, AnEmptySystemHasAnEmptySolution) {
  EXPECT_EQ(solve(LinearSystem{}).coefficients.size(), 0);
}

TEST(SymmetricFactorization, AgreesForBothOrderings) {
  const LinearSystem system = laplacian(20);
  const Eigen::VectorXd amd =
      SymmetricFactorization(system.matrix, Ordering::amd).solve(system.right_hand_side);
  const Eigen::VectorXd metis =
      SymmetricFactorization(system.matrix, Ordering::metis).solve(system.right_hand_side);
  EXPECT_LT((amd - metis).norm(), 1e-13 * amd.norm());
}

TEST(SymmetricFactorization, EstimatesTheSmallestEigenvalue) {
  for (const int n : {5, 20, 60}) {
    const double sine = std::sin(0.5 * std::numbers::pi / (n + 1)), exact = 8 * sine * sine;
    const double estimate =
        SymmetricFactorization(laplacian(n).matrix, Ordering::amd).smallest_eigenvalue();
    EXPECT_GE(estimate, exact * (1 - 1e-10));
    EXPECT_LE(estimate, 2 * exact);
  }
}

TEST(LinearSystem, EnergyIsStationaryAtTheSolution) {
  LinearSystem system = laplacian(6);
  system.constant = 3;
  const Eigen::VectorXd solution = solve(system).coefficients;
  // E(c) = constant − ½ fᵀ c at the minimum, and grows by ½ δᵀ K δ beside it.
  EXPECT_NEAR(system.energy(solution), 3 - 0.5 * system.right_hand_side.dot(solution), 1e-13);
  Eigen::VectorXd beside = solution;
  beside[7] += 1e-3;
  EXPECT_NEAR(system.energy(beside) - system.energy(solution), 0.5 * 4 * 1e-6, 1e-14);
}

TEST(LinearSolver, RegularizationSolvesSingularSystemsThatAreCompatible) {
  LinearSystem system = ring(50);
  for (int i = 0; i < 50; ++i)
    system.right_hand_side[i] = std::sin(2 * std::numbers::pi * 3 * i / 50);
  EXPECT_THROW(solve(system), ComputationError) << "without it, this is a mistake";
  const LinearSolution solution = solve(system, {.refinement_steps = 4, .regularization = 1e-12});
  EXPECT_LT(solution.relative_residual, 1e-13);
  // The smallest of all solutions, whose mean is zero: an eigenvector of 2 − 2 cos(2π 3/50).
  const double eigenvalue = 2 - 2 * std::cos(2 * std::numbers::pi * 3 / 50);
  EXPECT_LT((solution.coefficients - system.right_hand_side / eigenvalue).norm(), 1e-3);
}

}  // namespace
}  // namespace rfm
