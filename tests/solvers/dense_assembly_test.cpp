#include "solvers/dense_assembly.hpp"

#include <gmock/gmock.h>

#include "basis/tensor_polynomials.hpp"
#include "core/error.hpp"
#include "core/evaluate.hpp"
#include "solvers/equations.hpp"
#include "solvers/form.hpp"
#include "solvers/newton.hpp"
#include "tests/solvers/sample_problems.hpp"

namespace rfm {
namespace {

using namespace test;
const Field x = x_coordinate(), y = y_coordinate();

// Splines of one cell are the polynomials of both degrees, so that both assemblies must solve the
// same problem.
TEST(DenseAssembly, SolvesInTheSpanOfPolynomialsAsSplinesOfOneCellDo) {
  const Grid grid({2, {-0.9, -0.2}, {1.3, 1.3}}, {1, 1, 1});
  const DomainRule rule = rule_for(triangle(), grid, 14);
  const Structure u = sin(x) + (x + 1.1) * (1.5 - y) * Structure::undetermined();
  const EquationTerms terms{.stiffness = {{diffusion(2, 1 + x * x, 0.4, exp(y))}}};
  const Equations splines({u}, {TensorProductSpace(grid, 4)}, terms, rule);
  const Equations polynomials(
      {u},
      GlobalSpaces{std::make_shared<TensorPolynomials>(
          grid.box(), PolynomialFamily{PolynomialFamily::Kind::legendre, 4, false})},
      terms, rule);
  ASSERT_EQ(splines.size(), polynomials.size());
  const auto solved = [](const Equations& equations) {
    return equations.fields(solve(equations.steady()).coefficients)[0];
  };
  const Field a = solved(splines), b = solved(polynomials);
  // Uniform splines of one cell are nearly dependent on a part of it: digits of u are lost, not of
  // the energy.
  EXPECT_LT(norms(a - b, rule).h1_seminorm, 1e-6);
  const auto energy = [](const Equations& equations) {
    return equations.steady().energy(solve(equations.steady()).coefficients);
  };
  EXPECT_NEAR(energy(splines), energy(polynomials), 1e-12);
}

TEST(DenseAssembly, OfWeakFormsIsThatOfSplinesOfOneCell) {
  const Grid grid({2, {-0.9, -0.2}, {1.3, 1.3}}, {1, 1, 1});
  const DomainRule rule = rule_for(triangle(), grid, 12);
  const std::vector<Structure> structures{sin(x) +
                                          (x + 1.1) * (1.5 - y) * Structure::undetermined()};
  const Field u = unknown_symbol(0, 2), v = test_symbol(0, 2);
  const Contribution part =
      Form::weak(partial(u, 0) * partial(v, 0) + partial(u, 1) * partial(v, 1) +
                 5.0 * y * partial(u, 0) * v + u * v - exp(y) * v)
          .linear();
  const auto solved = [&](const Equations& equations) {
    EXPECT_FALSE(equations.steady().symmetric);
    return equations.fields(solve(equations.steady()).coefficients)[0];
  };
  const EquationTerms terms{.stiffness = {part}};
  const GlobalSpaces polynomials{std::make_shared<TensorPolynomials>(
      grid.box(), PolynomialFamily{PolynomialFamily::Kind::legendre, 3, false})};
  const Field a = solved(Equations(structures, {TensorProductSpace(grid, 3)}, terms, rule));
  const Field b = solved(Equations(structures, polynomials, terms, rule));
  EXPECT_LT(norms(a - b, rule).h1_seminorm, 1e-8);
}

// −∇·((1 + u²) ∇u) = f on the unit disk, by Newton's method over the equations as they are.
TEST(DenseAssembly, ServesNewtonsMethod) {
  const Field exact = sin(2.0 * x + y) + 0.5 * x * y, omega = 1.0 - x * x - y * y;
  const Field u = unknown_symbol(0, 2), v = test_symbol(0, 2);
  Field f = 0.0, flux = 0.0;
  for (const int axis : {0, 1}) {
    f = f - partial((1.0 + exact * exact) * partial(exact, axis), axis);
    flux = flux + partial(u, axis) * partial(v, axis);
  }
  const Form form = Form::weak((1.0 + u * u) * flux - f * v);
  const DomainRule rule = rule_for(circle({0, 0}, 1), Grid({2, {-1, -1}, {1, 1}}, {8, 8, 1}), 7);
  const auto solved = [&](int degree) {
    const GlobalSpaces spaces{std::make_shared<TensorPolynomials>(
        rule.grid().box(), PolynomialFamily{PolynomialFamily::Kind::legendre, degree, true})};
    const Equations whole({exact + omega * cos(x - y) + omega * Structure::undetermined()}, spaces,
                          {.stiffness = {}, .forms = {form}}, rule);
    const NewtonSolution solution =
        solve_newton(newton_equations(whole), Eigen::VectorXd::Zero(whole.size()));
    EXPECT_NEAR(solution.order().value_or(0), 2, 0.45);  // of the last three steps
    return norms(whole.fields(solution.linear.coefficients)[0] - exact, rule).l2;
  };
  const double sixth = solved(6), twelfth = solved(12);
  EXPECT_LT(twelfth, 1e-8);
  EXPECT_GT(sixth / twelfth, 1e3);
}

// A space of the user's own: the functions of one harmonic problem.
class Harmonics final : public GlobalSpace {
 public:
  int dimension() const override { return 2; }
  int size() const override { return 4; }
  Box valid() const override { return {2, {-2, -2}, {2, 2}}; }
  void evaluate(const std::array<const double*, 3>& coordinates, int count,
                const MultiIndex& derivative, double* values) const override {
    for (int q = 0; q < count; ++q, values += 4)
      for (int f = 0; f < 4; ++f)
        values[f] = evaluate_one(f, {coordinates[0][q], coordinates[1][q]}, derivative);
  }

 private:
  static double evaluate_one(int f, const Point& point, const MultiIndex& alpha) {
    const std::array<Field, 4> functions{Field(1.0), x, y, exp(x) * cos(y)};
    return value_at(partial(functions[f], alpha), point);
  }
};

TEST(DenseAssembly, TakesAnyFunctionsThatAUserHas) {
  // The natural condition ∂u/∂n = ∂w/∂n and a reaction select w = 2 + e^x cos y, which is in the
  // space, on the triangle.
  const Field w = 2.0 + exp(x) * cos(y);
  const DomainRule rule = rule_for(triangle(), triangle_grid(), 6);
  QuadraticEnergy flux;
  flux.add_load(value(), normal_derivative(w, 2));
  const Equations equations(
      {Structure::undetermined()}, GlobalSpaces{std::make_shared<Harmonics>()},
      {.stiffness = {{diffusion(2, 1.0, 1.0, w)}, {flux, Contribution::Place::boundary}}}, rule);
  const Eigen::VectorXd c = solve(equations.steady()).coefficients;
  EXPECT_NEAR(c[0], 2, 1e-9);
  EXPECT_NEAR(c[3], 1, 1e-9);
  EXPECT_LT(norms(equations.fields(c)[0] - w, rule).l2, 1e-10);
}

TEST(DenseAssembly, RefusesSpacesThatDoNotFit) {
  const DomainRule rule = rule_for(triangle(), triangle_grid(), 2);
  const std::vector<Structure> u{Structure::undetermined()};
  const std::vector<Contribution> terms{{diffusion(2, 1.0, 1.0, 1.0)}};
  EXPECT_THROW(assemble_dense(u, {}, terms, rule), InvalidArgument);
  EXPECT_THROW(
      assemble_dense(u, {std::make_shared<TensorPolynomials>(Box{1, {0}, {1}}, PolynomialFamily{})},
                     terms, rule),
      InvalidArgument);
  EXPECT_THROW(
      assemble_dense(std::vector<Structure>{Structure::undetermined(1)},
                     {std::make_shared<TensorPolynomials>(rule.grid().box(), PolynomialFamily{})},
                     terms, rule),
      InvalidArgument);
}

}  // namespace
}  // namespace rfm
