#include <gmock/gmock.h>

#include "core/error.hpp"
#include "tests/problems/solved_text.hpp"

namespace rfm {
namespace {

using testing::HasSubstr;

const std::string membrane =
    "dimension: 2\n"
    "geometry: {shapes: {sheet: {box: {min: [0, 0], max: [pi, pi]}}}, domain: sheet}\n"
    "physics: {type: membrane, tension: 1, density: 1}\n"
    "conditions: [{at: all, value: 0}]\n"
    "study: {type: eigen, count: 1}\n"
    "discretization: {basis: {bspline: 3, cells: 8}}\n";

TEST(Modes, AreThoseWithoutDataAndSaySo) {
  const ScalarSolution plain = test::solved(membrane);
  EXPECT_TRUE(plain.notes.empty());
  EXPECT_NEAR(plain.eigen->values[0], 2, 1e-4);
  for (const std::string change : {"conditions.0.value=1 + x", "physics.load=1"}) {
    const ScalarSolution loaded = test::solved(membrane, {change});
    EXPECT_NEAR(loaded.eigen->values[0], plain.eigen->values[0], 1e-12) << change;
    ASSERT_EQ(loaded.notes.size(), 1u) << change;
    EXPECT_THAT(loaded.notes[0], HasSubstr("of the equations without data")) << change;
  }
}

// P waves and S waves of a square along whose walls it slides
// (tests/verification/forms/lame_modes).
const std::string sliding =
    "dimension: 2\n"
    "geometry: {shapes: {block: {box: {min: [0, 0], max: [pi, pi]}}}, domain: block}\n"
    "conditions:\n"
    "  - {at: [block.left, block.right], value: {u: 0}}\n"
    "  - {at: [block.bottom, block.top], value: {v: 0}}\n"
    "study: {type: eigen, count: 6}\n"
    "discretization: {basis: {bspline: 3, cells: 8}}\n";
const std::string shear = "mu*(dx(u)^2 + dy(v)^2) + mu/2*(dy(u) + dx(v))^2\n";
const std::vector<double> lame = {1, 1.75, 1.75, 2.5, 2.5, 3.5};

TEST(Modes, OfAnUnknownWithoutMassFollowTheOthers) {
  // The pressure p = -lambda div u is an unknown of its own, and has neither a mass nor a level.
  const ScalarSolution mixed =
      test::solved(sliding +
                   "parameters: {lambda: 1.5, mu: 1}\n"
                   "physics:\n  type: custom\n  unknowns: [u, v, p]\n  mass: u^2 + v^2\n"
                   "  energy: -p*(dx(u) + dy(v)) - p^2/(2*lambda) + " +
                   shear);
  for (std::size_t i = 0; i < lame.size(); ++i)
    EXPECT_NEAR(mixed.eigen->values[i], lame[i], 1e-4 * lame[i]) << i;
  ASSERT_EQ(mixed.notes.size(), 1u);
  EXPECT_THAT(mixed.notes[0], HasSubstr("'p' has no mass"));
  const std::vector<Field>& push = mixed.eigen->modes[1];
  const Field divergence = partial(push[0], 0) + partial(push[1], 1);
  EXPECT_LT(norms(push[2] + 1.5 * divergence, mixed.rule).maximum, 1e-2);
  EXPECT_GT(norms(push[2], mixed.rule).maximum, 0.3);
}

TEST(Modes, OfAWeakFormThatFollowsFromNoEnergyAreRefused) {
  const std::string carried = "0.3*dx(u)*test(u)";
  const auto modes = [&](const std::string& form) {
    return test::solved(sliding +
                        "parameters: {lambda: 1.5, mu: 1}\n"
                        "physics:\n  type: custom\n  unknowns: [u, v]\n  mass: u^2 + v^2\n"
                        "  boundary: [{at: block.top, weak: \"" +
                        form +
                        "\"}]\n"
                        "  energy: lambda/2*(dx(u) + dy(v))^2 + " +
                        shear);
  };
  EXPECT_NEAR(modes("0*u*test(u)").eigen->values[0], 1, 1e-4);
  try {
    modes(carried);
    FAIL() << "not refused";
  } catch (const ComputationError& error) {
    EXPECT_THAT(error.what(), HasSubstr("symmetric"));
  }
}

TEST(Modes, OfUnknownsOfAnyMeaningAreNumbersByName) {
  // Two drums with springs of stiffness 1 between them: together as one, and 2 higher against each
  // other.
  const ScalarSolution drums = test::solved(
      "dimension: 2\n"
      "geometry: {shapes: {sheet: {box: {min: [0, 0], max: [pi, pi]}}}, domain: sheet}\n"
      "physics:\n  type: custom\n  unknowns: [a, b, c]\n  mass: (a^2 + b^2 + c^2)/2\n"
      "  energy: (dx(a)^2 + dy(a)^2 + dx(b)^2 + dy(b)^2 + (a - b)^2 + dx(c)^2 + dy(c)^2 + "
      "0.3*c^2)/2\n"
      "conditions: [{at: all, value: {a: 0, b: 0, c: 0}}]\n"
      "study: {type: eigen, count: 3}\n"
      "discretization: {basis: {bspline: 3, cells: 8}}\n");
  for (const auto& [number, value] : {std::pair{0, 2.0}, {1, 2.3}, {2, 4.0}})
    EXPECT_NEAR(drums.eigen->values[number], value, 1e-4);
  EXPECT_THAT(output_names(drums.results), testing::Contains("mode3.b"));
  EXPECT_EQ(mode_parts(drums.results, 1),
            (std::vector<std::string>{"mode2.a", "mode2.b", "mode2.c"}));
  ExpressionScope scope;
  define_results(scope, drums.results);
  const Field sum = to_field(Expression("mode3.a + mode3.b"), scope);
  EXPECT_LT(norms(sum, drums.rule).maximum, 1e-9);
  EXPECT_EQ(evaluate(Expression("mode2"), scope).components.size(), 3u);
}

TEST(EquationsOfAFile, HoldResidualAndTangentOfWhatIsNotLinear) {
  const std::string text =
      "dimension: 2\n"
      "geometry: {shapes: {disk: {circle: {center: [0, 0], radius: 1}}}, domain: disk}\n"
      "physics: {type: heat, conductivity: 1 + u^2, source: 3}\n"
      "conditions: [{at: disk, value: x}]\n"
      "discretization: {basis: {bspline: 3, cells: 8}}\n";
  const Problem file = read_problem(make_source("case.yaml", text));
  const ScalarProblem problem(file);
  const ScalarSolution solution = problem.solve(problem.grid());
  const Equations equations = problem.equations(solution.rule, solution.grid);
  EXPECT_EQ(equations.terms().forms.size(), 1u);
  const Eigen::VectorXd zero = Eigen::VectorXd::Zero(equations.size());
  const double start = equations.residual(zero, 0).norm();
  EXPECT_LT(equations.residual(solution.linear.coefficients, 0).norm(), 1e-12 * start);
  const Eigen::VectorXd change = Eigen::VectorXd::Random(equations.size());
  const Eigen::VectorXd slope = equations.linearized(solution.linear.coefficients).matrix * change;
  const auto beside = [&](double step) {
    return equations.residual(solution.linear.coefficients + step * change, 0);
  };
  EXPECT_LT((slope - (beside(1e-4) - beside(-1e-4)) / 2e-4).norm(), 1e-6 * slope.norm());
}

}  // namespace
}  // namespace rfm
