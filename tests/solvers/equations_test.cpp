#include "solvers/equations.hpp"

#include <gmock/gmock.h>

#include "core/evaluate.hpp"
#include "solvers/eigen_pairs.hpp"
#include "solvers/newton.hpp"
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

// u' = ∇·((1 + u²) ∇u) + f in the unit disk, u = 0 on the circle; reaction as a linear term.
class NonlinearDisk : public testing::Test {
 protected:
  Grid grid_{{2, {-1.03, -1.05}, {1.06, 1.02}}, {8, 8, 1}};
  DomainRule rule_ = rule_for(circle({0, 0}, 1), grid_, 7);

  Equations equations(const Field& source, double reaction = 0) const {
    const Field u = unknown_symbol(0, 2), v = test_symbol(0, 2);
    Field conduction = 0.0;
    for (const int axis : {0, 1}) conduction = conduction + partial(u, axis) * partial(v, axis);
    QuadraticEnergy capacity, spring;
    capacity.add_stiffness(value(), value(), 1.0);
    spring.add_stiffness(value(), value(), reaction);
    EquationTerms terms{.stiffness = {}, .damping = {{capacity}}};
    if (reaction != 0) terms.stiffness = {{spring}};
    terms.forms = {Form::weak((1.0 + u * u) * conduction - source * v)};
    return Equations({(1 - x * x - y * y) * Structure::undetermined()},
                     {TensorProductSpace(grid_, 3, cells_in_region(rule_, 3))}, std::move(terms),
                     rule_);
  }

  // The source by which (1 − r²) e^(−t) is the solution: with w = 1 − r², Δw = −4, |∇w|² = 4 r².
  static Field source() {
    const Field w = 1 - x * x - y * y, decay = exp(-coordinate(3)), u = w * decay;
    return -u + 4.0 * decay * (1.0 + u * u) - 8.0 * u * decay * decay * (x * x + y * y);
  }
};

TEST_F(NonlinearDisk, HasATangentThatIsTheDerivativeOfItsResidual) {
  for (const double reaction : {0.0, 7.0}) {
    const Equations disk = equations(exp(x) + coordinate(3), reaction);
    const Eigen::VectorXd state = Eigen::VectorXd::Random(disk.size()),
                          change = Eigen::VectorXd::Random(disk.size());
    const double step = 1e-4, time = 0.3;
    const LinearSystem at_state = disk.linearized(state, {time, {}});
    ASSERT_FALSE(at_state.symmetric);
    const Eigen::VectorXd slope = at_state.matrix * change,
                          difference = (disk.residual(state + step * change, time) -
                                        disk.residual(state - step * change, time)) /
                                       (2 * step);
    EXPECT_LT((slope - difference).norm(), 1e-6 * slope.norm());
    EXPECT_LT((at_state.right_hand_side + disk.residual(state, time)).norm(), 1e-14);
    EXPECT_GT((disk.residual(state, 0.8) - disk.residual(state, time)).norm(), 1e-2);
  }
}

TEST_F(NonlinearDisk, IsSolvedByNewtonsMethodAtAnyTime) {
  // Without u' the source of (1 − r²) e^(−t) has no −u.
  const Field u = (1 - x * x - y * y) * exp(-coordinate(3));
  const Equations steady = equations(source() + u);
  for (const double time : {0.0, 1.0}) {
    const NewtonSolution found =
        solve_newton(newton_equations(steady, {time, {}}), Eigen::VectorXd::Zero(steady.size()));
    EXPECT_NEAR(found.order().value_or(0), 2, 0.5);
    EXPECT_LT(steady.residual(found.linear.coefficients, time).norm(), 1e-12);
    EXPECT_LT(
        norms(steady.fields(found.linear.coefficients)[0] - std::exp(-time) * (1 - x * x - y * y),
              rule_)
            .l2,
        1e-9);
  }
}

// M (c − c₋) / Δt + R(c, t) = 0 for c, step by step: Euler's implicit method.
Eigen::VectorXd integrated_implicitly(const Equations& equations, Eigen::VectorXd now, double end,
                                      int steps) {
  const double step = end / steps;
  const SparseMatrix damping = equations.damping().selfadjointView<Eigen::Lower>();
  for (int n = 1; n <= steps; ++n) {
    NewtonEquations of_step = newton_equations(equations, {n * step, {}});
    of_step.at = [&, steady = of_step.at, before = now](const Eigen::VectorXd& state) {
      LinearSystem system = steady(state);
      system.matrix = SparseMatrix(system.matrix + damping / step);
      system.right_hand_side -= damping * (state - before) / step;
      return system;
    };
    now = solve_newton(of_step, now).linear.coefficients;
  }
  return now;
}

TEST_F(NonlinearDisk, CoolsByADriverInTimeWithTheOrderOfItsMethod) {
  const Equations heat = equations(source());
  const double end = 0.5;
  const auto error = [&](int steps) {
    const Eigen::VectorXd start = Eigen::VectorXd::Ones(heat.size());  // 1 − r²
    return norms(heat.fields(integrated_implicitly(heat, start, end, steps))[0] -
                     std::exp(-end) * (1 - x * x - y * y),
                 rule_)
        .l2;
  };
  const double coarse = error(8), fine = error(16);
  EXPECT_NEAR(std::log2(coarse / fine), 1, 0.1);
  EXPECT_LT(fine, 5e-3);
  EXPECT_GT(fine, 1e-5);
}

}  // namespace
}  // namespace rfm
