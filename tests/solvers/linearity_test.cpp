#include "solvers/linearity.hpp"

#include <gtest/gtest.h>

#include "solvers/collocation.hpp"
#include "solvers/equations.hpp"
#include "tests/solvers/form_algebra.hpp"
#include "tests/solvers/sample_problems.hpp"

namespace rfm {
namespace {

using namespace test;

const Field x = x_coordinate(), y = y_coordinate();
const Field u = unknown_symbol(0, 2), v = test_symbol(0, 2);

const Field one = pow(cos(u), 2) + pow(sin(u), 2);

const DomainRule& triangle_rule() {
  static const DomainRule rule = rule_for(triangle(), triangle_grid(), 2);
  return rule;
}

TEST(LinearByValue, AreFormsWhoseTermsCancel) {
  for (const Form& form :
       {Form::energy(0.5 * squared_slope(u) + pow(u, 3) - u * u * u - exp(x) * u),
        Form::energy(0.5 * one * squared_slope(u) + 0.5 * x * u * u - y * u),
        Form::weak((1.0 + (u + 1.0) * (u - 1.0) - u * u) * dot(gradient(u, 2), gradient(v, 2)) +
                   (3.0 + one) * v * partial(u, 0) - v),
        Form::least_squares({laplacian(u, 2) + one * u - x, partial(u, 1)},
                            {1.0 + x * x, Field(2.0)})}) {
    EXPECT_FALSE(form.is_linear());
    EXPECT_TRUE(is_linear_by_value(form, triangle_rule()));
    EXPECT_EQ(linearity(std::span(&form, 1), triangle_rule()), Linearity::by_value);
  }
}

TEST(LinearByValue, AreNoFormsWhoseTangentsChange) {
  for (const Form& form :
       {Form::energy(0.5 * squared_slope(u) + 1e-6 * pow(u, 4)),
        Form::energy(sqrt(1.0 + squared_slope(u))),
        Form::weak((1.0 + u * u) * dot(gradient(u, 2), gradient(v, 2)) - v),
        Form::weak(partial(u, 0) * partial(v, 0) + u * partial(u, 0) * v),
        Form::weak(partial(u, 0) * partial(v, 0) + max(u - 50.0, 0.0) * v),
        // Only on a part of the domain, and only where u is small.
        Form::weak(partial(u, 0) * partial(v, 0) + max(x - 0.5, 0.0) * u * u * v),
        Form::weak(partial(u, 0) * partial(v, 0) + u * exp(-u * u * 1e4) * v),
        Form::least_squares({laplacian(u, 2) + u * u})})
    EXPECT_FALSE(is_linear_by_value(form, triangle_rule())) << form.slots().size();
}

TEST(LinearByValue, AreNoFormsThatJump) {
  // The tangent is the same everywhere; the residual is not what it makes of u.
  const Form form =
      Form::weak(partial(u, 0) * partial(v, 0) + sign(u - 0.3) * v + u * u * v - u * u * v * 1.0);
  const Form jump = Form::weak(partial(u, 0) * partial(v, 0) * one + sign(u - 0.3) * v);
  EXPECT_FALSE(is_linear_by_value(form, triangle_rule()));
  EXPECT_FALSE(is_linear_by_value(jump, triangle_rule()));
}

TEST(LinearByValue, AreNoFormsWithoutValues) {
  EXPECT_FALSE(
      is_linear_by_value(Form::energy(log(u) - log(u) + squared_slope(u)), triangle_rule()));
  EXPECT_FALSE(is_linear_by_value(Form::energy(pow(u, 3) / u + squared_slope(u)), triangle_rule()));
}

TEST(LinearByValue, IsAMatterOfTheFormsOwnPlace) {
  // Nonlinear where x > 0.9 only: the last side of the triangle ends at x = 0.77.
  const Field term = max(x - 0.9, 0.0) * u * u * v + one * u * v;
  const auto on_side = [&](int side) {
    return is_linear_by_value(Form::weak(term, {Contribution::Place::boundary, {side}, {}}),
                              triangle_rule());
  };
  EXPECT_FALSE(on_side(0));
  EXPECT_FALSE(on_side(1));
  EXPECT_TRUE(on_side(2));
  const Form left = Form::weak(term, {Contribution::Place::volume, {}, 0.9 - x});
  EXPECT_TRUE(is_linear_by_value(left, triangle_rule()));
  EXPECT_FALSE(is_linear_by_value(Form::weak(term), triangle_rule()));
}

TEST(Linearity, IsByFormOnlyWhereAllFormsAre) {
  const Form plain = Form::weak(u * v), hidden = Form::weak(one * u * v),
             not_linear = Form::weak(u * u * v);
  const auto of = [](const std::vector<Form>& forms) { return linearity(forms, triangle_rule()); };
  EXPECT_EQ(of({plain, plain}), Linearity::by_form);
  EXPECT_EQ(of({plain, hidden}), Linearity::by_value);
  EXPECT_EQ(of({hidden, not_linear, plain}), Linearity::none);
}

// The equations at rest, solved, and what departs from them there.
double departure(const Form& form) {
  const DomainRule& rule = triangle_rule();
  const std::vector<TensorProductSpace> spaces{
      TensorProductSpace(rule.grid(), 2, cells_in_region(rule))};
  const std::vector<Structure> structures{sin(x + y) + (1.0 + x * y) * Structure::undetermined()};
  const std::vector<Structure> changes{homogeneous_part(structures[0])};
  const Contribution part = form.at(std::vector<Field>(form.slots().size(), 0.0));
  const LinearSystem system = assemble(structures, spaces, std::span(&part, 1), rule);
  const Eigen::VectorXd c = solve(system).coefficients;
  const Contribution there = form.linearized(solution_fields(structures, spaces, c));
  return departure_from_linear(
      system, c, assemble(changes, spaces, std::span(&there, 1), rule).right_hand_side);
}

TEST(DepartureFromLinear, IsRoundingOfLinearFormsAndNotOfOthers) {
  const Field energy = 0.5 * squared_slope(u) + 0.5 * u * u - 3.0 * u;
  EXPECT_LT(departure(Form::energy(energy)), 1e-13);
  EXPECT_LT(departure(Form::energy(energy + pow(u, 3) - u * u * u)), 1e-12);
  EXPECT_LT(departure(Form::weak(dot(gradient(u, 2), gradient(v, 2)) + one * u * v - x * v +
                                 partial(u, 0) * v)),
            1e-12);
  // At the solution, u is near 3.
  EXPECT_GT(departure(Form::energy(energy + 1e-3 * pow(u, 4))), 1e-5);
  EXPECT_GT(departure(Form::weak(dot(gradient(u, 2), gradient(v, 2)) + u * v - 3.0 * v +
                                 max(u - 2.0, 0.0) * v)),
            1e-4);
}

TEST(DepartureFromLinear, MakesCollocationGoOnWhereFormsOnlyLookedLinear) {
  // −Δu + u + cubic term = f with the value as a residual; said to be linear.
  const Grid grid = Grid::with_square_cells({2, {-1.05, -1.1}, {1.1, 1.02}}, 6);
  const DomainRule rule = rule_for(circle({0, 0}, 1), grid, 3);
  const std::vector<TensorProductSpace> spaces{
      TensorProductSpace(grid, 3, cells_in_region(rule, 3))};
  const Field omega = 1.0 - x * x - y * y, exact = omega * (1.0 + x);
  const std::vector<Structure> structures{omega * Structure::undetermined()};
  NewtonOptions options;
  options.looks_linear = true;
  const auto steps_and_error = [&](const Field& more) {
    const Field residual = more + u - laplacian(u, 2);
    const std::vector<Field> solution{exact};
    const std::vector<Form> forms{
        Form::least_squares({residual - with_solution(residual, solution)})};
    const NewtonSolution found = solve_collocation(structures, spaces, forms, rule, options);
    const Field error = solution_fields(structures, spaces, found.linear.coefficients)[0] - exact;
    return std::pair(found.iterations.size(), norms(error, rule).l2);
  };
  const auto [no_steps, error] = steps_and_error(pow(u, 3) - u * u * u);
  EXPECT_EQ(no_steps, 0u);
  EXPECT_LT(error, 1e-11);
  const auto [steps, nonlinear_error] = steps_and_error(0.5 * pow(u, 3));
  EXPECT_GT(steps, 2u);
  EXPECT_LT(nonlinear_error, 1e-11);
}

}  // namespace
}  // namespace rfm
