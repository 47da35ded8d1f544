#include "solvers/newton.hpp"

#include <gmock/gmock.h>

#include "core/error.hpp"
#include "solvers/extension.hpp"
#include "tests/solvers/form_algebra.hpp"
#include "tests/solvers/sample_problems.hpp"

namespace rfm {
namespace {

using namespace test;
using testing::HasSubstr;

const Field x = x_coordinate(), y = y_coordinate();

// u = g + ω Ψ on a region, g equal to the exact solution on the boundary only.
struct NonlinearProblem {
  int dimension = 2;
  Region region = circle({0, 0}, 1);
  Field omega = 1.0 - x * x - y * y;
  Field exact, data;
  Form form;
  Box box{2, {-1.05, -1.1}, {1.1, 1.02}};

  struct Result {
    NewtonSolution newton;
    FieldNorms error;
  };
  Result solve(int cells, int degree, const NewtonOptions& options = {}) const {
    const Grid grid = Grid::with_square_cells(box, cells);
    const DomainRule rule = rule_for(region, grid, degree);
    const std::vector<TensorProductSpace> spaces{
        TensorProductSpace(grid, degree, cells_in_region(rule, degree))};
    const std::vector<Structure> structures{data + omega * Structure::undetermined()};
    LinearSolverOptions linear;
    linear.dimension = dimension;
    Result result{solve_newton(structures, spaces, std::span(&form, 1), rule, linear, options), {}};
    const Field solution =
        solution_fields(structures, spaces, result.newton.linear.coefficients)[0];
    result.error = norms(solution - exact, rule_for(region, grid, degree + 2));
    return result;
  }
};

const Field u = unknown_symbol(0, 2), v = test_symbol(0, 2);

// The catenoid cosh z = |p − (3, 0.5)| is a minimal surface over every region where it is a graph.
NonlinearProblem minimal_surface() {
  const Field r = hypot(x - 3.0, y - 0.5), exact = log(r + sqrt(r * r - 1.0));
  const Field omega = 1.0 - x * x - y * y;
  return {.exact = exact,
          .data = exact + omega * (1.0 + x * exp(y)),
          .form = Form::energy(sqrt(1.0 + dot(gradient(u, 2), gradient(u, 2))))};
}

// −∇·((1 + u²) ∇u) = f.
NonlinearProblem nonlinear_diffusion() {
  const Field exact = sin(2.0 * x + y) + 0.5 * x * y;
  const Field omega = 1.0 - x * x - y * y;
  Field f = 0.0;
  for (const int axis : {0, 1}) f = f - partial((1.0 + exact * exact) * partial(exact, axis), axis);
  return {.exact = exact,
          .data = exact + omega * cos(x - y),
          .form = Form::weak((1.0 + u * u) * dot(gradient(u, 2), gradient(v, 2)) - f * v)};
}

class NewtonOn : public testing::TestWithParam<int> {
 protected:
  NonlinearProblem problem = GetParam() == 0 ? minimal_surface() : nonlinear_diffusion();
};
INSTANTIATE_TEST_SUITE_P(Problems, NewtonOn, testing::Values(0, 1));

TEST_P(NewtonOn, ConvergesQuadratically) {
  const NewtonSolution solution = problem.solve(10, 3).newton;
  EXPECT_LE(solution.iterations.size(), 10u);
  ASSERT_TRUE(solution.order());
  EXPECT_GT(*solution.order(), 1.7);
  EXPECT_LT(*solution.order(), 2.4);
  EXPECT_LT(solution.iterations.back().step, 1e-9);
}

TEST_P(NewtonOn, HasTheOrderOfTheSplines) {
  for (const int degree : {2, 3}) {
    const FieldNorms coarse = problem.solve(10, degree).error;
    const FieldNorms fine = problem.solve(20, degree).error;
    EXPECT_NEAR(std::log2(coarse.l2 / fine.l2), degree + 1, 0.3) << degree;
    EXPECT_NEAR(std::log2(coarse.h1_seminorm / fine.h1_seminorm), degree, 0.3) << degree;
    EXPECT_LT(fine.l2, degree == 3 ? 2e-5 : 3e-4);
  }
}

TEST_P(NewtonOn, LoadStepsEndAtTheSameSolution) {
  NewtonOptions options;
  options.load_steps = 3;
  const auto direct = problem.solve(6, 2), gradual = problem.solve(6, 2, options);
  EXPECT_LT((direct.newton.linear.coefficients - gradual.newton.linear.coefficients).norm(),
            1e-9 * direct.newton.linear.coefficients.norm());
  EXPECT_GT(gradual.newton.iterations.size(), direct.newton.iterations.size());
  // The first of three brings the residual down by a third, and the steps of each begin anew.
  EXPECT_NEAR(gradual.newton.iterations[0].residual, direct.newton.iterations[0].residual / 3,
              1e-12 * direct.newton.iterations[0].residual);
}

TEST(Newton, SolvesALinearProblemInOneStep) {
  NonlinearProblem problem = minimal_surface();
  problem.form = Form::energy(0.5 * dot(gradient(u, 2), gradient(u, 2)) - exp(x) * u);
  const NewtonSolution solution = problem.solve(8, 3).newton;
  // The second step is rounding.
  ASSERT_EQ(solution.iterations.size(), 2u);
  EXPECT_LT(solution.iterations[1].step, 1e-12);
}

// −u″ = λ eᵘ, u(0) = u(1) = 0, has no solution for λ > 3.5138 and two below.
NonlinearProblem bratu(double lambda) {
  const Field w = unknown_symbol(0, 1);
  return {.dimension = 1,
          .region = unit_box(1),
          .omega = x * (1.0 - x),
          .exact = 0.0,
          .data = 0.0,
          .form = Form::energy(0.5 * partial(w, 0) * partial(w, 0) - lambda * exp(w)),
          .box = {1, {0}, {1}}};
}

TEST(Newton, FindsTheLowerBranchOfBratu) {
  // u(½) = 2 log cosh θ with θ = √(2λ)/4 · 2 cosh θ: for λ = 1, θ = 0.379291497..., u(½) =
  // 0.14053921.
  NonlinearProblem problem = bratu(1);
  double theta = 0.38;
  for (int i = 0; i < 60; ++i) theta = std::sqrt(2.0) / 4 * std::cosh(theta);
  problem.exact = -2.0 * log(cosh((2 * theta) * (x - 0.5)) / Field(std::cosh(theta)));
  const auto result = problem.solve(16, 4);
  EXPECT_LT(result.error.maximum, 1e-8);
  EXPECT_GT(result.newton.order().value_or(2), 1.7);
}

std::string failure_of(const NonlinearProblem& problem) {
  try {
    problem.solve(8, 2);
  } catch (const ComputationError& error) {
    return error.what();
  }
  return "none";
}

TEST(Newton, SaysThatItDoesNotConvergeBeyondTheFold) {
  EXPECT_THAT(failure_of(bratu(6)), HasSubstr("Newton's method does not converge"));
}

TEST(Newton, SaysThatTheHessianIsIndefinite) {
  // −60 eʷ outweighs ½ w′² in the lowest modes already at w = 0.
  EXPECT_THAT(failure_of(bratu(60)), HasSubstr("the Hessian of the energy is indefinite"));
}

TEST(Newton, SaysThatTheResidualFallsNoFurther) {
  // A load that jumps with the sign of w − 0.3 has a tangent of zero: steps go to and fro.
  NonlinearProblem problem = bratu(1);
  const Field w = unknown_symbol(0, 1), v = test_symbol(0, 1);
  problem.form = Form::weak(partial(w, 0) * partial(v, 0) + 100.0 * sign(w - 0.3) * v - 10.0 * v);
  EXPECT_THAT(failure_of(problem), HasSubstr("the residual falls no further"));
}

TEST(Newton, SaysThatTheTangentVanishesAtTheStart) {
  // The energy |∇u|⁴ / 4 − u and the residual |∇u|² − 1 have no tangent at u = 0, and no solution.
  NonlinearProblem problem = bratu(1);
  const Field w = unknown_symbol(0, 1);
  problem.form = Form::energy(pow(partial(w, 0), 4.0) / 4.0 - w);
  EXPECT_THAT(failure_of(problem), HasSubstr("the tangent vanishes at the start"));
  problem.form = Form::least_squares({pow(partial(w, 0), 2.0) - 1.0});
  EXPECT_THAT(failure_of(problem), HasSubstr("the tangent vanishes at the start"));
}

TEST(Newton, EndsAfterOneStepWhereAFormOnlyLooksNonlinear) {
  // cos² + sin² is 1, which the formula of the tangent does not tell.
  NonlinearProblem problem = minimal_surface();
  problem.form = Form::energy(
      0.5 * (pow(cos(u), 2) + pow(sin(u), 2)) * dot(gradient(u, 2), gradient(u, 2)) - exp(x) * u);
  EXPECT_FALSE(problem.form.is_linear());
  const NewtonSolution solution = problem.solve(8, 3).newton;
  ASSERT_EQ(solution.iterations.size(), 2u);
  EXPECT_LT(solution.iterations[1].step, 1e-11);
}

TEST(Newton, NamesThePlaceWhereAFormIsNotDefined) {
  NonlinearProblem problem = bratu(1);
  const Field w = unknown_symbol(0, 1);
  problem.form = Form::energy(0.5 * partial(w, 0) * partial(w, 0) + log(w - 0.5));
  EXPECT_THAT(failure_of(problem), HasSubstr("not a number at the point ("));
}

TEST(Newton, FindsTheSolutionInExtendedSplines) {
  const NonlinearProblem problem = nonlinear_diffusion();
  const auto error_of = [&](int cells) {
    const Grid grid = Grid::with_square_cells(problem.box, cells);
    const DomainRule rule = rule_for(problem.region, grid, 2);
    const std::vector<TensorProductSpace> spaces{
        TensorProductSpace(grid, 2, cells_in_region(rule, 2))};
    const std::vector<Structure> structures{problem.data +
                                            problem.omega * Structure::undetermined()};
    const SplineExtension extension(spaces, rule);
    NewtonOptions options;
    options.extraction = &extension;
    const NewtonSolution solution =
        solve_newton(structures, spaces, std::span(&problem.form, 1), rule, {}, options);
    EXPECT_GT(*solution.order(), 1.7);
    // In the span of the extended splines, and not in the whole one.
    const Eigen::VectorXd& c = solution.linear.coefficients;
    EXPECT_LT((c - extension.matrix * extension.reduced(c)).norm(), 1e-13 * c.norm());
    EXPECT_LT(static_cast<int>(extension.inner.size()), spaces[0].size());
    return norms(solution_fields(structures, spaces, c)[0] - problem.exact,
                 rule_for(problem.region, grid, 4))
        .l2;
  };
  const double coarse = error_of(20), fine = error_of(40);
  EXPECT_NEAR(std::log2(coarse / fine), 3, 0.5);
}

TEST(Newton, RefusesNoLoadSteps) {
  NewtonOptions options;
  options.load_steps = 0;
  EXPECT_THROW(bratu(1).solve(4, 2, options), InvalidArgument);
}

}  // namespace
}  // namespace rfm
