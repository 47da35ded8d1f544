#include "solvers/assembly.hpp"

#include <gmock/gmock.h>
#include <tbb/global_control.h>

#include <Eigen/Dense>
#include <numeric>
#include <random>

#include "core/error.hpp"
#include "solvers/energy.hpp"
#include "tests/solvers/sample_problems.hpp"

namespace rfm {
namespace {

using namespace test;
using Place = Contribution::Place;
const Field x = x_coordinate(), y = y_coordinate(), z = z_coordinate();

// Two components coupled in the volume and on the boundary, two undetermined functions of
// different degrees (one on a part of the region only), derivatives of second order, normals, a
// restriction, inhomogeneous parts.
struct CoupledProblem {
  Grid grid;
  DomainRule rule = rule_for(triangle(), grid, 3);
  std::vector<TensorProductSpace> spaces{{grid, 2, cells_in_region(rule)},
                                         {grid, 3, cells_of_a_band()}};
  std::vector<Structure> structures{x * y + (1.0 + x) * Structure::undetermined(0),
                                    sin(x) + y* Structure::undetermined(1) +
                                        x* x* partial(Structure::undetermined(0), 1) +
                                        0.5 * Structure::undetermined(0)};
  std::vector<Contribution> contributions;

  // The second space leaves out splines inside the region.
  std::vector<std::uint8_t> cells_of_a_band() const {
    std::vector<std::uint8_t> cells = cells_in_region(rule);
    for (int cell = 0; cell < grid.cell_count(); ++cell)
      if (grid.position(cell)[0] > 2) cells[cell] = 0;
    return cells;
  }

  explicit CoupledProblem(const Grid& grid = triangle_grid(5)) : grid(grid) {
    QuadraticEnergy volume;
    volume.add_stiffness(slope(0, 0), slope(0, 0), 2.0 + x);
    volume.add_stiffness(slope(1, 0), slope(0, 1), y);
    volume.add_stiffness({1, {0, 2}}, {1, {0, 2}}, 0.1);
    volume.add_stiffness(value(1), value(0), exp(x));
    volume.add_load(value(0), x * x);
    volume.add_load(slope(1, 1), y);
    QuadraticEnergy boundary;
    boundary.add_stiffness(value(0), slope(0, 1), Coefficient::normal(0) * (1.0 + y));
    boundary.add_stiffness(value(1), value(1), Coefficient::normal(1) * Coefficient::normal(0));
    boundary.add_load(value(0), Coefficient::normal(1) * x + 3.0);
    QuadraticEnergy part;
    part.add_stiffness(value(0), value(0), 5.0);
    part.add_load(slope(0, 0), 1.0);
    contributions = {{volume, Place::volume},
                     {boundary, Place::boundary},
                     {part, Place::boundary, {1}, y - 0.4}};
  }

  double energy(const std::vector<Field>& u) const {
    double sum = 0;
    for (const Contribution& contribution : contributions)
      sum += rfm::energy(contribution, u, rule);
    return sum;
  }
};

class AssemblyOn : public testing::TestWithParam<Grid> {};
const std::vector<double> unequal_lines[] = {{-0.9, -0.7, -0.2, 0.4, 0.45, 1.3},
                                             {-0.2, 0.1, 0.2, 0.9, 1.3}};
INSTANTIATE_TEST_SUITE_P(Grids, AssemblyOn,
                         testing::Values(triangle_grid(5), Grid::with_lines(unequal_lines)));

TEST_P(AssemblyOn, GivesTheEnergyOfTheSolutionField) {
  const CoupledProblem problem(GetParam());
  const LinearSystem system =
      assemble(problem.structures, problem.spaces, problem.contributions, problem.rule);
  ASSERT_EQ(system.size(), problem.spaces[0].size() + problem.spaces[1].size());
  std::mt19937 generator(2);
  std::uniform_real_distribution<double> uniform(-1, 1);
  for (int sample = 0; sample < 4; ++sample) {
    Eigen::VectorXd coefficients = Eigen::VectorXd::Zero(system.size());
    if (sample > 0)
      for (double& coefficient : coefficients) coefficient = uniform(generator);
    const double expected =
        problem.energy(solution_fields(problem.structures, problem.spaces, coefficients));
    EXPECT_NEAR(system.energy(coefficients), expected, 1e-12 * std::abs(expected)) << sample;
  }
}

TEST(Assembly, GivesEveryEntryOfTheMatrixByPolarisation) {
  const CoupledProblem problem;
  const LinearSystem system =
      assemble(problem.structures, problem.spaces, problem.contributions, problem.rule);
  const Eigen::MatrixXd lower(system.matrix);
  const auto unit = [&](int i) { return Eigen::VectorXd::Unit(system.size(), i); };
  const auto energy = [&](const Eigen::VectorXd& c) {
    return problem.energy(solution_fields(problem.structures, problem.spaces, c));
  };
  // K_ij = E(e_i + e_j) − E(e_i) − E(e_j) + E(0), f_i = −(E(e_i) − E(−e_i))/2: every 5th pair.
  const double zero = energy(Eigen::VectorXd::Zero(system.size()));
  EXPECT_NEAR(system.constant, zero, 1e-13);
  for (int i = 3; i < system.size(); i += 5) {
    const double at_i = energy(unit(i));
    EXPECT_NEAR(system.right_hand_side[i], (energy(-unit(i)) - at_i) / 2, 1e-12);
    for (int j = 0; j <= i; j += 9)
      EXPECT_NEAR(lower(i, j), energy(unit(i) + unit(j)) - at_i - energy(unit(j)) + zero, 2e-11)
          << i << ", " << j;
  }
}

TEST(Assembly, IsTheSameBitByBitForAnyNumberOfThreads) {
  const Grid grid({2, {-1.1, -1.2}, {1.2, 1.1}}, {70, 66, 1});
  const DomainRule rule = rule_for(circle({0, 0}, 1), grid, 2);
  const TensorProductSpace space(grid, 2, cells_in_region(rule));
  const Structure structure = exp(x) + (1.0 - x * x - y * y) * Structure::undetermined();
  const Contribution contributions[] = {{diffusion(2, 1.0 + x * x, sin(y), cos(x)), Place::volume},
                                        {diffusion(2, 0.0, 3.0, x * y), Place::boundary}};
  const auto assembled = [&](int threads) {
    const tbb::global_control control(tbb::global_control::max_allowed_parallelism, threads);
    return assemble(std::span(&structure, 1), std::span(&space, 1), contributions, rule);
  };
  const LinearSystem one = assembled(1), two = assembled(2);
  EXPECT_EQ((one.matrix.coeffs() - two.matrix.coeffs()).abs().maxCoeff(), 0);
  EXPECT_EQ((one.right_hand_side - two.right_hand_side).cwiseAbs().maxCoeff(), 0);
  EXPECT_EQ(one.constant, two.constant);
}

TEST(Assembly, DropsNothingWhenContributionsAreSplit) {
  const CoupledProblem problem;
  const LinearSystem together =
      assemble(problem.structures, problem.spaces, problem.contributions, problem.rule);
  Eigen::VectorXd right_hand_side = Eigen::VectorXd::Zero(together.size());
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(together.size(), together.size());
  for (const Contribution& contribution : problem.contributions) {
    const LinearSystem part =
        assemble(problem.structures, problem.spaces, std::span(&contribution, 1), problem.rule);
    right_hand_side += part.right_hand_side;
    matrix += Eigen::MatrixXd(part.matrix);
  }
  EXPECT_LT((matrix - Eigen::MatrixXd(together.matrix)).cwiseAbs().maxCoeff(), 1e-12);
  EXPECT_LT((right_hand_side - together.right_hand_side).cwiseAbs().maxCoeff(), 1e-13);
}

TEST(Assembly, TakesTimeAndParametersAsArguments) {
  const Grid grid({1, {0}, {1}}, {4, 1, 1});
  const DomainRule rule = rule_for(unit_box(1), grid, 2);
  const TensorProductSpace space(grid, 2, cells_in_region(rule));
  const Structure structure = Structure::undetermined();
  QuadraticEnergy energy;
  energy.add_load(value(), time_coordinate() * parameter(1));
  const Contribution contribution{energy};
  const LinearSystem system = assemble(std::span(&structure, 1), std::span(&space, 1),
                                       std::span(&contribution, 1), rule, {2.0, {7.0, 0.5}});
  EXPECT_NEAR(system.right_hand_side.sum(), 1.0, 1e-15);  // splines sum to one
}

TEST(Assembly, AGivenComponentLoadsWhatItIsCoupledTo) {
  // ∫ u v with v = x given, in either order of the components: f_i = −∫ x B_i, Σ f_i = −1/2.
  const Grid grid({1, {0}, {1}}, {4, 1, 1});
  const DomainRule rule = rule_for(unit_box(1), grid, 2);
  const TensorProductSpace space(grid, 2);
  for (const int unknown : {0, 1}) {
    std::vector<Structure> structures(2, x);
    structures[unknown] = Structure::undetermined();
    QuadraticEnergy energy;
    energy.add_stiffness(value(0), value(1), 1.0);
    const Contribution contribution{energy};
    const LinearSystem system =
        assemble(structures, std::span(&space, 1), std::span(&contribution, 1), rule);
    EXPECT_NEAR(system.right_hand_side.sum(), -0.5, 1e-15);
  }
}

TEST(Assembly, NamesTheQuantityAndThePointThatIsNotFinite) {
  const Grid grid({1, {0}, {1}}, {3, 1, 1});
  const DomainRule rule = rule_for(unit_box(1), grid, 2);
  const TensorProductSpace space(grid, 2, cells_in_region(rule));
  const auto assembled = [&](const Structure& structure, const Field& k, const Field& f) {
    const Contribution contribution{diffusion(1, k, 1.0, f)};
    assemble(std::span(&structure, 1), std::span(&space, 1), std::span(&contribution, 1), rule);
  };
  using testing::AllOf, testing::HasSubstr, testing::ThrowsMessage;
  const Structure psi = Structure::undetermined();
  EXPECT_THAT([&] { assembled(psi, 1.0, 1.0 / (x - x)); },
              ThrowsMessage<ComputationError>(AllOf(HasSubstr("source"), HasSubstr("point (0.0"))));
  EXPECT_THAT([&] { assembled(psi, log(x - 0.5), 1.0); },
              ThrowsMessage<ComputationError>(HasSubstr("coefficient of the equation")));
  EXPECT_THAT([&] { assembled(log(x - 2.0) * psi, 1.0, 1.0); },
              ThrowsMessage<ComputationError>(HasSubstr("undetermined function in u0")));
}

TEST(Assembly, DoesNotLookWhereAContributionDoesNotCount) {
  const Grid grid({1, {0}, {1}}, {3, 1, 1});
  const DomainRule rule = rule_for(unit_box(1), grid, 2);
  const TensorProductSpace space(grid, 2, cells_in_region(rule));
  const Structure structure = Structure::undetermined();
  const Contribution contribution{
      diffusion(1, 1.0, 1.0, 1.0 / sqrt(x - 1 / 3.)), Place::volume, {}, x - 1 / 3.};
  const LinearSystem system =
      assemble(std::span(&structure, 1), std::span(&space, 1), std::span(&contribution, 1), rule);
  EXPECT_TRUE(system.right_hand_side.allFinite());
  EXPECT_EQ(system.matrix.coeff(0, 0), 0);  // the first spline lives left of 1/3 only
}

TEST(Assembly, RefusesWhatDoesNotFitTogether) {
  const Grid grid({2, {0, 0}, {1, 1}}, {3, 3, 1}), other({2, {0, 0}, {1, 1}}, {3, 4, 1});
  const DomainRule rule = rule_for(unit_box(2), grid, 2);
  const auto assembled = [&](const Structure& structure, const TensorProductSpace& space,
                             const Contribution& contribution) {
    assemble(std::span(&structure, 1), std::span(&space, 1), std::span(&contribution, 1), rule);
  };
  const Structure psi = Structure::undetermined();
  const TensorProductSpace space(grid, 2);
  const Contribution good{diffusion(2, 1.0, 1.0, 1.0)};
  EXPECT_NO_THROW(assembled(psi, space, good));
  EXPECT_THROW(assembled(psi, TensorProductSpace(other, 2), good), InvalidArgument);
  EXPECT_THROW(assembled(Structure::undetermined(1), space, good), InvalidArgument);
  QuadraticEnergy energy;
  energy.add_stiffness(value(1), value(1), 1.0);
  EXPECT_THROW(assembled(psi, space, {energy}), InvalidArgument);
  energy = {};
  energy.add_load(value(), Coefficient::normal(0));
  EXPECT_THROW(assembled(psi, space, {energy}), InvalidArgument);
  energy = {};
  energy.add_load({0, {0, 0, 1}}, 1.0);  // ∂/∂z in the plane
  EXPECT_THROW(assembled(psi, space, {energy}), InvalidArgument);
}

// A disk or ball of radius 1 + height around the origin, with grid lines at ±1 and cells of 1/2.
DomainRule touching_ball(int dimension, double height, int degree) {
  const Grid grid({dimension, {-1.5, -1.5, -1.5}, {1.5, 1.5, 1.5}}, {6, 6, dimension > 2 ? 6 : 1});
  const Region ball = dimension > 2 ? sphere({0, 0, 0}, 1 + height) : circle({0, 0}, 1 + height);
  return rule_for(ball, grid, degree);
}

int flagged(const DomainRule& rule, int degree) {
  const std::vector<std::uint8_t> flags = cells_in_region(rule, degree);
  return std::accumulate(flags.begin(), flags.end(), 0);
}

TEST(CellsInRegion, LeaveOutCapsThatAreTooSmallToCount) {
  for (const int dimension : {2, 3}) {
    const int without = flagged(touching_ball(dimension, -1e-3, 3), 3);
    const int caps = dimension > 2 ? 6 * 4 : 4 * 2;  // the cells that meet at the poles
    EXPECT_EQ(flagged(touching_ball(dimension, 1e-8, 3), 3), without);
    EXPECT_EQ(flagged(touching_ball(dimension, 1e-2, 3), 3), without + caps);
  }
}

TEST(CellsInRegion, ABallThatTouchesGridLinesIsSolved) {
  // −Δu + u = 1 with du/dn = 0 has the solution 1, which splines that are left out are missing for.
  for (const int dimension : {2, 3})
    for (const int degree : {1, 2, 3})
      for (const double height : {0.0, 1e-12, 1e-8, 1e-4}) {
        const DomainRule rule = touching_ball(dimension, height, degree);
        const TensorProductSpace space(rule.grid(), degree, cells_in_region(rule, degree));
        const Contribution contribution{diffusion(dimension, 1, 1, 1)};
        const Field u = solve_one(Structure::undetermined(), space, {&contribution, 1}, rule);
        EXPECT_LT(norms(u - 1, rule).h1(), dimension > 2 ? 1e-8 : 1e-11)
            << "degree " << degree << ", height " << height << ", dimension " << dimension;
      }
}

}  // namespace
}  // namespace rfm
