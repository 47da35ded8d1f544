#include <gmock/gmock.h>

#include <numbers>

#include "core/error.hpp"
#include "tests/problems/solved_text.hpp"

using namespace rfm;

namespace {

const std::string disk =
    "dimension: 2\n"
    "geometry: {shapes: {disk: {circle: {center: [0, 0], radius: 1}}}, domain: disk}\n";

std::string objection(const std::string& text, const std::vector<std::string>& overrides = {}) {
  try {
    test::solved(text, overrides);
  } catch (const ComputationError& error) {
    return error.what();
  }
  return "none";
}

// By every method and basis.
class EveryWay : public testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(ScalarTrust, EveryWay,
                         testing::Values("{method: ritz, basis: {bspline: 3, cells: 10}}",
                                         "{method: galerkin, basis: {bspline: 3, cells: 10}}",
                                         "{method: least_squares, basis: {bspline: 3, cells: 10}}",
                                         "{method: ritz, basis: {legendre: 8}}",
                                         "{method: galerkin, basis: {chebyshev: 8}}",
                                         "{method: least_squares, basis: {legendre: 8}}"));

TEST_P(EveryWay, FluxesOnTheWholeBoundaryHaveASolutionOnlyIfTheyBalance) {
  for (const char* diffusivity : {"1", "1 + 0.1*dx(u)^2", "1 + 0*u"}) {
    const std::string text = disk + "physics: {type: poisson, diffusivity: " + diffusivity +
                             "}\ndiscretization: " + GetParam() +
                             "\nconditions: [{at: disk, flux: ";
    const ScalarSolution solution = test::solved(text + "n.x}]\n");
    EXPECT_TRUE(solution.mean_set_to_zero) << diffusivity;
    const Field& u = solution.results.unknowns[0].field;
    EXPECT_NEAR(integrate(u, solution.rule), 0, 1e-10) << diffusivity;
    // x if the conductivity is 1; the flux goes through the middle in any case.
    const double heat = integrate(u * coordinate(0), solution.rule);
    EXPECT_NEAR(heat, std::numbers::pi / 4, diffusivity[1] == ' ' ? 0.1 : 1e-8) << diffusivity;
    EXPECT_THAT(objection(text + "n.x + 1e-3}]\n"), testing::HasSubstr("do not balance"))
        << diffusivity;
  }
}

TEST(ScalarTrust, LoadsThatDoNotBalanceAreFoundByNewtonsMethod) {
  for (const char* basis : {"{bspline: 3, cells: 10}", "{legendre: 8}"})
    for (const char* q : {"0", "1e-5", "0.1"}) {
      const std::string said = objection(
          disk +
          "physics:\n  type: custom\n  unknowns: [w]\n"
          "  energy: (dx(w)^2 + dy(w)^2)/2 + (dx(w)^2 + dy(w)^2)^2/4 - x*w\n"
          "  boundary: [{at: disk, energy: -(" +
          q + ")*w}]\nconditions: [{at: disk, free: true}]\ndiscretization: {basis: " + basis +
          "}\n");
      if (q[0] == '0' && q[1] == 0)
        EXPECT_EQ(said, "none") << basis;
      else
        EXPECT_THAT(said, testing::HasSubstr("nothing fixes the level of w, and the loads on it do "
                                             "not balance"))
            << basis << q;
    }
}

// Of a flow in a closed box the level of the pressure is free: its mean is zero.
TEST(ScalarTrust, PressuresBetweenWallsHaveMeanZeroInEveryBasis) {
  const std::string text =
      "dimension: 2\n"
      "geometry: {shapes: {disk: {circle: {center: [0, 0], radius: 1}}}, domain: disk}\n"
      "physics:\n  type: custom\n  unknowns: [u, v, p]\n"
      "  weak: dx(u)*dx(test(u)) + dy(u)*dy(test(u)) + dx(v)*dx(test(v)) + dy(v)*dy(test(v))"
      " - p*(dx(test(u)) + dy(test(v))) - test(p)*(dx(u) + dy(v))"
      " - (1 + 2*x)*test(u) - 3*test(v)\n"
      "conditions: [{at: disk, value: {u: VALUE, v: 0}}]\n";
  for (const char* basis : {"{bspline: 3, degrees: {p: 2}, cells: 8}", "{legendre: 8}"}) {
    const auto with = [&](const char* value) {
      std::string filled = text;
      return filled.replace(filled.find("VALUE"), 5, value) + "discretization: {basis: " + basis +
             "}\n";
    };
    // At rest: the pressure is that of the force, x + x² + 3 y, less its mean 1/4.
    const ScalarSolution rest = test::solved(with("0"));
    const Field x = coordinate(0), y = coordinate(1);
    EXPECT_LT(norms(rest.results.unknowns[2].field - (x + x * x + 3 * y - 0.25), rest.rule).maximum,
              basis[1] == 'b' ? 1e-5 : 1e-8)  // splines in cut cells: quadrature
        << basis;
    EXPECT_THAT(objection(with("x")), testing::HasSubstr("nothing fixes the level of p")) << basis;
  }
}

TEST(ScalarTrust, RadiationFixesTheLevel) {
  const ScalarSolution solution =
      test::solved(disk +
                   "physics: {type: poisson, source: 2}\nconditions: [{at: disk, flux: -u^4}]\n"
                   "discretization: {basis: {bspline: 3, cells: 10}, solver: {load_steps: 1}}\n");
  // −Δu = 2 and u⁴ = 1 on the circle: u = 1 + (1 − r²)/2.
  const Field exact = 1.5 - 0.5 * (coordinate(0) * coordinate(0) + coordinate(1) * coordinate(1));
  EXPECT_LT(norms(solution.results.unknowns[0].field - exact, solution.rule).maximum, 1e-7);
}

TEST(ScalarTrust, DataMayVanishOnTheBoundaryButForRounding) {
  const ScalarSolution solution =
      test::solved(disk +
                   "physics: {type: poisson, source: 4}\n"
                   "conditions: [{at: disk, value: (x^2 + y^2 - 1)*x}]\n"
                   "discretization: {basis: {bspline: 3, cells: 10}}\n");
  EXPECT_LT(solution.boundary_residual, 1e-14);
}

}  // namespace
