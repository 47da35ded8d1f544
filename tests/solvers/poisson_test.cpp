#include <gmock/gmock.h>

#include "core/error.hpp"
#include "tests/solvers/sample_problems.hpp"

/// Assembly, linear solver, solution and norms together, on problems with known solutions.
namespace rfm {
namespace {

using namespace test;
using Place = Contribution::Place;
const Field x = x_coordinate(), y = y_coordinate(), z = z_coordinate();

struct Errors {
  double l2, h1;
};

// −Δu = f, u = 0 on the unit box, by u = ω Ψ. The grid is shifted and larger than the box, unless
// `fitted`.
Errors poisson_errors(int dimension, int degree, int cells, bool fitted) {
  Field exact = 1.0;
  for (int axis = 0; axis < dimension; ++axis)
    exact = exact * sin(3.0 * coordinate(axis)) * (1.0 - coordinate(axis));
  const double low = fitted ? 0 : -0.071, high = fitted ? 1 : 1.043;
  const Grid grid({dimension, {low, low, low}, {high, high, high}}, {cells, cells, cells});
  const DomainRule rule = rule_for(unit_box(dimension), grid, degree);
  const TensorProductSpace space(grid, degree, cells_in_region(rule));
  const Contribution contribution{diffusion(dimension, 1.0, 0.0, -laplacian(exact, dimension))};
  const Field solution = solve_one(unit_box_weight(dimension) * Structure::undetermined(), space,
                                   std::span(&contribution, 1), rule);
  const FieldNorms error = norms(solution - exact, rule);
  return {error.l2, error.h1_seminorm};
}

class Poisson : public testing::TestWithParam<std::tuple<int, int, bool>> {};
INSTANTIATE_TEST_SUITE_P(Plane, Poisson,
                         testing::Combine(testing::Values(2), testing::Values(1, 2, 3, 4),
                                          testing::Bool()));
INSTANTIATE_TEST_SUITE_P(Line, Poisson,
                         testing::Combine(testing::Values(1), testing::Values(1, 2, 3, 5),
                                          testing::Bool()));

INSTANTIATE_TEST_SUITE_P(Space, Poisson,
                         testing::Combine(testing::Values(3), testing::Values(1, 2),
                                          testing::Bool()));

TEST_P(Poisson, ConvergesWithTheOrderOfItsSplinesAndNoFaster) {
  const auto [dimension, degree, fitted] = GetParam();
  const int cells = dimension == 3 ? 6 : degree > 3 ? 8 : 16;
  const Errors coarse = poisson_errors(dimension, degree, cells, fitted);
  const Errors fine = poisson_errors(dimension, degree, 2 * cells, fitted);
  EXPECT_NEAR(std::log2(coarse.l2 / fine.l2), degree + 1, 0.25);
  EXPECT_NEAR(std::log2(coarse.h1 / fine.h1), degree, 0.2);
}

// −Δu = f between two circles. The prescribed g equals u on the boundary only.
Errors ring_errors(int degree, int cells) {
  const Field outer = 1.0 - x * x - y * y;
  const Field inner = pow(x - 0.15, 2) + pow(y + 0.1, 2) - 0.16;
  const Field exact = sin(2.0 * x - y) * exp(0.5 * y);
  const Region region = circle({0, 0}, 1) - circle({0.15, -0.1}, 0.4);
  const Grid grid({2, {-1.04, -1.03}, {1.05, 1.06}}, {cells, cells, 1});
  const DomainRule rule = rule_for(region, grid, degree);
  const TensorProductSpace space(grid, degree, cells_in_region(rule));
  const Contribution contribution{diffusion(2, 1.0, 0.0, -laplacian(exact, 2))};
  const Field g = exact + outer * inner * cos(3.0 * y);
  const Field solution = solve_one(g + outer * inner * Structure::undetermined(), space,
                                   std::span(&contribution, 1), rule);
  const FieldNorms error = norms(solution - exact, rule);
  return {error.l2, error.h1_seminorm};
}

class Ring : public testing::TestWithParam<int> {};
INSTANTIATE_TEST_SUITE_P(Poisson, Ring, testing::Range(1, 6));

TEST_P(Ring, ConvergesWithFullOrderOnCurvedBoundaries) {
  const int degree = GetParam(), cells = 18;
  const Errors coarse = ring_errors(degree, cells), fine = ring_errors(degree, 2 * cells);
  EXPECT_NEAR(std::log2(coarse.l2 / fine.l2), degree + 1, 0.5);
  EXPECT_NEAR(std::log2(coarse.h1 / fine.h1), degree, 0.4);
}

// −Δu + u = f with fluxes on the whole boundary, on a triangle that the grid cuts at odd places:
// quadrature is exact there, so a polynomial of the degree of the splines is found exactly.
class PatchTest : public testing::TestWithParam<int> {};
INSTANTIATE_TEST_SUITE_P(EveryDegree, PatchTest, testing::Range(1, 6));

Field polynomial(int degree) { return pow(x + 0.3 * y - 0.2, degree) + x - 2.0 * y + 0.5; }

TEST_P(PatchTest, NaturalConditionsReproducePolynomials) {
  const int degree = GetParam();
  const Field exact = polynomial(degree);
  const DomainRule rule = rule_for(triangle(), triangle_grid(), degree);
  const TensorProductSpace space(rule.grid(), degree, cells_in_region(rule));
  QuadraticEnergy flux;
  flux.add_load(value(), normal_derivative(exact, 2));
  const Contribution contributions[] = {
      {diffusion(2, 1.0, 1.0, exact - laplacian(exact, 2)), Place::volume},
      {flux, Place::boundary}};
  const Field solution = solve_one(Structure::undetermined(), space, contributions, rule);
  EXPECT_LT(norms(solution - exact, rule).l2, 1e-12);
  EXPECT_LT(norms(solution - exact, rule).h1_seminorm, 1e-10);
}

// −Δu = f, u = `exact` on the boundary, by ½ β (u − g)² − (u − g) ∂u/∂n there: terms without u
// only shift the energy.
Field nitsche_solution(const Field& exact, int degree, const DomainRule& rule) {
  const int dimension = rule.dimension();
  const TensorProductSpace space(rule.grid(), degree, cells_in_region(rule));
  const double penalty = 40 * degree * degree / rule.grid().spacing(0);
  QuadraticEnergy nitsche;
  nitsche.add_stiffness(value(), value(), penalty);
  nitsche.add_load(value(), penalty * exact);
  for (int axis = 0; axis < dimension; ++axis) {
    nitsche.add_stiffness(value(), slope(axis), -Coefficient::normal(axis));
    nitsche.add_load(slope(axis), -Coefficient::normal(axis) * exact);
  }
  const Contribution contributions[] = {
      {diffusion(dimension, 1.0, 0.0, -laplacian(exact, dimension)), Place::volume},
      {nitsche, Place::boundary}};
  return solve_one(Structure::undetermined(), space, contributions, rule);
}

TEST_P(PatchTest, NitschesMethodReproducesPolynomials) {
  const int degree = GetParam();
  const Field exact = polynomial(degree);
  const DomainRule rule = rule_for(triangle(), triangle_grid(), degree);
  EXPECT_LT(norms(nitsche_solution(exact, degree, rule) - exact, rule).l2, 1e-10);
}

TEST(PatchTest, NitschesMethodReproducesPolynomialsInSpace) {
  // A cube with a corner cut off.
  const Region region = unit_box(3) & level_set(2.1 - x - y - z, 3);
  const Grid grid({3, {-0.07, -0.02, -0.05}, {1.03, 1.09, 1.04}}, {4, 3, 4});
  const Field exact = pow(x + 0.3 * y - 0.6 * z, 2) + x - 2.0 * y * z + 0.5;
  const DomainRule rule = rule_for(region, grid, 2);
  EXPECT_LT(norms(nitsche_solution(exact, 2, rule) - exact, rule).l2, 1e-10);
}

TEST(Poisson, RobinConditionsHoldOnTheirPieceOnly) {
  // u'' = 0 on (0, 1): u' = 2 u on the left with outward normal −1 (so −u' + 2 u = 0), u = 3 right.
  // u = 1 + 2 x. On the left ½ · 2 u² joins the energy; u = 3 + (x − 1) Ψ.
  const Grid grid({1, {-0.13}, {1.08}}, {6, 1, 1});
  const DomainRule rule = rule_for(unit_box(1), grid, 2);
  const TensorProductSpace space(grid, 2, cells_in_region(rule));
  QuadraticEnergy robin;
  robin.add_stiffness(value(), value(), 2.0);
  const Contribution contributions[] = {{diffusion(1, 1.0, 0.0, 0.0), Place::volume},
                                        {robin, Place::boundary, {0}}};
  const Field solution =
      solve_one(3.0 + (x - 1.0) * Structure::undetermined(), space, contributions, rule);
  EXPECT_LT(norms(solution - (1.0 + 2.0 * x), rule).maximum, 1e-13);
}

TEST(Poisson, AnisotropicMatricesOfConductivityAreSymmetricProducts) {
  // ½ ∇uᵀ K ∇u with K = [3 1; 1 2]: −div(K ∇u) = f, u = ω P with a polynomial P is found exactly.
  const Field exact = unit_box_weight(2) * (1.0 + x * y * y);
  const Field u_x = partial(exact, 0), u_y = partial(exact, 1);
  const Field f = -partial(3.0 * u_x + u_y, 0) - partial(u_x + 2.0 * u_y, 1);
  const Grid grid({2, {0, 0}, {1, 1}}, {4, 3, 1});
  const DomainRule rule = rule_for(unit_box(2), grid, 4);
  const TensorProductSpace space(grid, 2, cells_in_region(rule));
  QuadraticEnergy energy;
  energy.add_stiffness(slope(0), slope(0), 3.0);
  energy.add_stiffness(slope(0), slope(1), 1.0);
  energy.add_stiffness(slope(1), slope(1), 2.0);
  energy.add_load(value(), f);
  const Contribution contribution{energy};
  const Field solution = solve_one(unit_box_weight(2) * Structure::undetermined(), space,
                                   std::span(&contribution, 1), rule);
  EXPECT_LT(norms(solution - exact, rule).maximum, 1e-14);
}

TEST(Poisson, FluxesAloneDoNotDetermineASolution) {
  const DomainRule rule = rule_for(triangle(), triangle_grid(), 3);
  const TensorProductSpace space(rule.grid(), 3, cells_in_region(rule));
  const Contribution contribution{diffusion(2, 1.0, 0.0, x)};
  EXPECT_THAT(
      [&] { solve_one(Structure::undetermined(), space, std::span(&contribution, 1), rule); },
      testing::ThrowsMessage<ComputationError>(testing::HasSubstr("condition is missing")));
}

}  // namespace
}  // namespace rfm
