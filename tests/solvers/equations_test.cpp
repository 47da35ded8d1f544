#include "solvers/equations.hpp"

#include <gmock/gmock.h>

#include "core/evaluate.hpp"
#include "solvers/eigen_pairs.hpp"
#include "tests/solvers/sample_problems.hpp"

/// Studies as drivers over the equations of one problem: steady, eigenvalues, and time.
namespace rfm {
namespace {

using namespace test;
const Field x = x_coordinate(), y = y_coordinate();
constexpr std::array<double, 6> bessel_zeros = {2.404825557695773,  5.520078110286311,
                                                8.653727912911012,  11.791534439014281,
                                                14.930917708487785, 18.071063967910922};

// u' − Δu = f in the unit disk, u = 0 on the circle, by u = (1 − r²) Ψ.
class Disk : public testing::Test {
 protected:
  Grid grid_{{2, {-1.03, -1.05}, {1.06, 1.02}}, {24, 24, 1}};
  DomainRule rule_ = rule_for(circle({0, 0}, 1), grid_, 3);

  Equations equations(const Field& source) const {
    QuadraticEnergy capacity;
    capacity.add_stiffness(value(), value(), 1.0);
    return Equations({(1 - x * x - y * y) * Structure::undetermined()},
                     {TensorProductSpace(grid_, 3, cells_in_region(rule_, 3))},
                     {.stiffness = {{diffusion(2, 1.0, 0.0, source)}},
                      .damping = {{capacity}},
                      .mass = {{capacity}}},
                     rule_);
  }
};

TEST_F(Disk, IsSolvedAsASteadyProblem) {
  const Equations torsion = equations(4.0);
  const LinearSolution solution = solve(torsion.steady());
  EXPECT_LT(norms(torsion.fields(solution.coefficients)[0] - (1 - x * x - y * y), rule_).l2, 1e-9);
  EXPECT_LT(torsion.residual(solution.coefficients, 0).norm(), 1e-12);
}

TEST_F(Disk, HasEigenvaluesWhichAreSquaresOfZerosOfBesselFunctions) {
  const Equations drum = equations(0.0);
  const EigenPairs modes = eigen_pairs(drum.stiffness(), drum.mass(), {.count = 6});
  EXPECT_NEAR(modes.pairs[0].value, std::pow(bessel_zeros[0], 2), 1e-6);
  EXPECT_NEAR(modes.pairs[1].value, 14.681970642123893, 1e-5);
  EXPECT_NEAR(modes.pairs[2].value, 14.681970642123893, 1e-5);
  EXPECT_NEAR(modes.pairs[5].value, std::pow(bessel_zeros[1], 2), 1e-3);
}

// The second-order backward differences (3 u − 4 u₋ + u₋₋) / 2 Δt = −K u + f, after one step of
// Euler's implicit method.
Eigen::VectorXd integrated(const Equations& equations, Eigen::VectorXd start, double end,
                           int steps) {
  const double step = end / steps;
  const auto times_damping = [&](const Eigen::VectorXd& c) -> Eigen::VectorXd {
    return equations.damping().selfadjointView<Eigen::Lower>() * c;
  };
  const auto solved = [&](double factor, const Eigen::VectorXd& right) {
    LinearSystem system = equations.steady();
    system.matrix = SparseMatrix(system.matrix + factor * equations.damping());
    system.right_hand_side = right;
    return solve(system).coefficients;
  };
  Eigen::VectorXd before = start;
  Eigen::VectorXd now = solved(1 / step, equations.load(step) + times_damping(start) / step);
  for (int n = 2; n <= steps; ++n) {
    const Eigen::VectorXd next =
        solved(1.5 / step, equations.load(n * step) + times_damping(2 * now - 0.5 * before) / step);
    before = std::exchange(now, next);
  }
  return now;
}

TEST_F(Disk, CoolsAsBesselFunctionsDoByADriverInTime) {
  // From 1 − r² without a source: Σ 8 / (z³ J₁(z)) J₀(z r) exp(−z² t).
  const Equations heat = equations(0.0);
  const double end = 0.2;
  const auto exact = [&](double r) {
    double sum = 0;
    for (const double zero : bessel_zeros)
      sum += 8 / (std::pow(zero, 3) * std::cyl_bessel_j(1, zero)) * std::cyl_bessel_j(0, zero * r) *
             std::exp(-zero * zero * end);
    return sum;
  };
  const auto error = [&](int steps) {
    const Eigen::VectorXd ones = Eigen::VectorXd::Ones(heat.size());  // Ψ = 1: splines add up to 1
    const Field u = heat.fields(integrated(heat, ones, end, steps))[0];
    double largest = 0;
    for (const double r : {0.0, 0.31, 0.77})
      largest = std::max(largest, std::abs(value_at(u, {r, 0}) - exact(r)));
    return largest;
  };
  const double coarse = error(20), fine = error(40);
  EXPECT_NEAR(std::log2(coarse / fine), 2, 0.2);
  EXPECT_LT(fine, 2e-4);
}

TEST_F(Disk, FollowsALoadThatGrowsWithTime) {
  // u = t (1 − r²) has u' − Δu = 1 − r² + 4 t, and backward differences are exact in time.
  const Equations heat = equations(1 - x * x - y * y + 4.0 * coordinate(3));
  const Eigen::VectorXd end = integrated(heat, Eigen::VectorXd::Zero(heat.size()), 0.5, 5);
  EXPECT_LT(norms(heat.fields(end)[0] - 0.5 * (1 - x * x - y * y), rule_).l2, 1e-9);
}

}  // namespace
}  // namespace rfm
