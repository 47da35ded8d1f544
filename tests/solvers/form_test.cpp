#include "solvers/form.hpp"

#include <gmock/gmock.h>

#include <random>

#include "core/error.hpp"
#include "core/evaluate.hpp"
#include "tests/solvers/form_algebra.hpp"
#include "tests/solvers/sample_problems.hpp"

namespace rfm {
namespace {

using namespace test;

const Field x = x_coordinate(), y = y_coordinate();
const Field u = unknown_symbol(0, 2), v = test_symbol(0, 2);

// A structure with data on a triangle, and random coefficients.
struct State {
  Grid grid = triangle_grid(5);
  DomainRule rule = rule_for(triangle(), grid, 2);
  std::vector<TensorProductSpace> spaces{TensorProductSpace(grid, 2, cells_in_region(rule))};
  std::vector<Structure> structures{sin(x + y) + (1.0 + x * y) * Structure::undetermined()};
  std::vector<Structure> changes{(1.0 + x * y) * Structure::undetermined()};
  Eigen::VectorXd coefficients = random(1), direction = random(2);

  Eigen::VectorXd random(int seed) const {
    std::mt19937 generator(static_cast<unsigned>(seed));
    std::uniform_real_distribution<double> uniform(-1, 1);
    Eigen::VectorXd numbers(spaces[0].size());
    for (double& number : numbers) number = uniform(generator);
    return numbers;
  }
  std::vector<Field> fields(const Eigen::VectorXd& c) const {
    return solution_fields(structures, spaces, c);
  }
  // Minus the residual, and the tangent times the direction.
  std::pair<Eigen::VectorXd, Eigen::VectorXd> linearized(const Form& form,
                                                         const Eigen::VectorXd& c) const {
    const Contribution part = form.linearized(fields(c));
    const LinearSystem system = assemble(changes, spaces, std::span(&part, 1), rule);
    const Eigen::VectorXd product =
        system.symmetric
            ? Eigen::VectorXd(system.matrix.selfadjointView<Eigen::Lower>() * direction)
            : Eigen::VectorXd(system.matrix * direction);
    return {system.right_hand_side, product};
  }
};

// Central differences with one step of Richardson's extrapolation: error O(h⁴).
template <class Function>
auto slope_at_zero(const Function& f, double h) {
  using Value = decltype(f(h));
  const auto central = [&](double step) { return Value((f(step) - f(-step)) / (2 * step)); };
  return Value((4 * central(h / 2) - central(h)) / 3);
}

TEST(Form, ResidualIsTheSlopeOfTheEnergy) {
  const State state;
  const Form form = Form::energy(sqrt(1.0 + squared_slope(u)) + exp(u) * x + y * u);
  const auto energy = [&](double t) {
    return integrate(form.density(state.fields(state.coefficients + t * state.direction)),
                     state.rule);
  };
  const double slope = slope_at_zero(energy, 1e-2);
  EXPECT_NEAR(-state.linearized(form, state.coefficients).first.dot(state.direction), slope,
              1e-8 * std::abs(slope));
}

class TangentOf : public testing::TestWithParam<int> {};
INSTANTIATE_TEST_SUITE_P(Kinds, TangentOf, testing::Values(0, 1, 2));

TEST_P(TangentOf, AFormIsTheSlopeOfItsResidual) {
  const State state;
  // Of least squares, where the residual is affine: Gauss's and Newton's tangent leaves out what is
  // multiplied by second derivatives of the residual.
  const Form form = std::vector<Form>{
      Form::energy(sqrt(1.0 + squared_slope(u)) + exp(u) * x),
      Form::weak((1.0 + u * u) * dot(gradient(u, 2), gradient(v, 2)) + u * partial(u, 0) * v),
      Form::least_squares({laplacian(u, 2) - x * u - 1.0, partial(u, 1)},
                          {1.0 + x * x, Field(2.0)})}[GetParam()];
  const auto residual = [&](double t) {
    return Eigen::VectorXd(-state.linearized(form, state.coefficients + t * state.direction).first);
  };
  const Eigen::VectorXd slope = slope_at_zero(residual, 1e-2);
  const Eigen::VectorXd product = state.linearized(form, state.coefficients).second;
  EXPECT_LT((product - slope).norm(), 1e-7 * slope.norm());
}

TEST(Form, IsLinearWhereItsTangentDoesNotDependOnTheUnknowns) {
  EXPECT_TRUE(Form::energy(0.5 * squared_slope(u) - exp(x) * u).is_linear());
  EXPECT_TRUE(Form::weak(partial(u, 0) * v + sin(x) * v).is_linear());
  EXPECT_TRUE(Form::least_squares({laplacian(u, 2) + u - x}).is_linear());
  EXPECT_FALSE(Form::energy(squared_slope(u) * u).is_linear());
  EXPECT_FALSE(Form::weak(u * u * v).is_linear());
  EXPECT_FALSE(Form::least_squares({laplacian(u, 2) + u * u}).is_linear());
  EXPECT_THROW(Form::weak(u * u * v).linear(), InvalidArgument);
}

TEST(Form, CoefficientsThatAreNotDefinedEverywhereMakeNoTermsMore) {
  const Field k = sqrt(x) / y;
  const Slot along_x{0, unit_index(0)}, along_y{0, unit_index(1)};
  for (const Form& form : {Form::weak(k * dot(gradient(u, 2), gradient(v, 2)) + log(x) * v),
                           Form::energy(0.5 * k * squared_slope(u) + log(x) * u)}) {
    EXPECT_TRUE(form.is_linear());
    EXPECT_TRUE(form.tangent(along_x, along_y, 2).is_constant(0));
    EXPECT_FALSE(form.tangent(along_x, along_x, 2).is_constant(0));
  }
}

TEST(Form, OfAQuadraticEnergyIsTheSameSystemAsByHand) {
  const State state;
  const Field k = 1.0 + x * x / (2.0 + y);
  const Contribution by_hand{diffusion(2, k, exp(y), sin(x))};
  const Contribution form =
      Form::energy(0.5 * k * squared_slope(u) + 0.5 * exp(y) * u * u - sin(x) * u).linear();
  const LinearSystem a =
      assemble(state.structures, state.spaces, std::span(&by_hand, 1), state.rule);
  const LinearSystem b = assemble(state.structures, state.spaces, std::span(&form, 1), state.rule);
  EXPECT_LT((a.matrix.coeffs() - b.matrix.coeffs()).abs().maxCoeff(),
            1e-14 * a.matrix.coeffs().abs().maxCoeff());
  EXPECT_LT((a.right_hand_side - b.right_hand_side).norm(), 1e-14 * a.right_hand_side.norm());
}

TEST(Form, DerivativesOfExpressionsAreCarriedOutDownToTheUnknowns) {
  // ∂(x² u)/∂x = 2 x u + x² u_x, and a second derivative of u² is 2 u_x² + 2 u u_xx.
  const Field w = sin(x) * exp(y);
  const std::vector<Field> solution{w};
  const Form form = Form::energy(partial(x * x * u, 0) * partial(partial(u * u, 0), 0));
  EXPECT_EQ(form.derivative_order(), 2);
  const Point place{0.3, 0.7};
  EXPECT_NEAR(value_at(form.density(solution), place),
              value_at(partial(x * x * w, 0) * partial(partial(w * w, 0), 0), place), 1e-13);
}

TEST(Form, SymbolsHaveNoValues) { EXPECT_TRUE(std::isnan(value_at(u, {0.1, 0.2}))); }

// The slope of sign(u) is zero, that of a corner is left out: slopes do not tell.
TEST(Form, IsNotLinearWhereItJumpsOrHasACornerInTheUnknowns) {
  const Field u = unknown_symbol(0, 2), v = test_symbol(0, 2);
  const Field square = 0.5 * dot(gradient(u, 2), gradient(u, 2));
  for (const Field& part : {sign(u), step(u - 0.5), abs(u), max(u, 0.5), min(u, 0.5),
                            select(step(u - 0.5), Field(14.0), Field(4.0))}) {
    EXPECT_FALSE(Form::energy(square + part * u).is_linear());
    EXPECT_FALSE(Form::weak(part * v).is_linear());
    EXPECT_FALSE(Form::least_squares({partial(u, MultiIndex{2, 0, 0}) + part}).is_linear());
  }
  for (const Field& corner : {abs(u), max(u, 0.5), min(u, 0.5)})
    EXPECT_FALSE(Form::energy(square + corner).is_linear());
  for (const Field& jump : {sign(u), step(u - 0.5)})
    EXPECT_THROW(Form::energy(square + jump), InvalidArgument);
  // Of coordinates they may.
  EXPECT_TRUE(Form::energy(square + sign(coordinate(0)) * u).is_linear());
}

TEST(Form, ThatIsNotLinearInTheTestFunctionIsRefused) {
  EXPECT_THROW(Form::weak(u * v + x), InvalidArgument);
  EXPECT_THROW(Form::weak(u * v * v), InvalidArgument);
  EXPECT_THROW(Form::weak(sin(v)), InvalidArgument);
  EXPECT_THROW(Form::energy(u * v), InvalidArgument);
  EXPECT_THROW(Form::least_squares({v}), InvalidArgument);
}

TEST(Form, AsksForComponentsThatThereAre) {
  const std::vector<Field> one{x};
  EXPECT_THROW(Form::energy(unknown_symbol(1, 2) * u).linearized(one), InvalidArgument);
}

TEST(Form, IsLinearInTestFunctionsAlsoWhereItIsDividedByWhatMayBeZero) {
  const Field r2 = x * x + y * y;
  for (const Field& form : {u * v / r2, (u * v + partial(u, 0) * partial(v, 0)) / sqrt(r2),
                            u / hypot(x, y) * (x * partial(v, 0) + y * partial(v, 1)) / r2})
    EXPECT_NO_THROW(Form::weak(form));
  EXPECT_THROW(Form::weak(u / v), InvalidArgument);
  EXPECT_THROW(Form::weak(u * v / (1 + v)), InvalidArgument);
}

}  // namespace
}  // namespace rfm
