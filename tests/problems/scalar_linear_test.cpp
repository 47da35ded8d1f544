#include <gtest/gtest.h>

#include "tests/problems/solved_text.hpp"

using namespace rfm;
using test::difference;

namespace {

// On a disk, with values on its circle.
ScalarSolution solved_on_disk(const std::string& physics,
                              const std::vector<std::string>& overrides = {}) {
  const std::string text =
      "dimension: 2\n"
      "fields: {one: cos(x)^2 + sin(x)^2}\n"
      "geometry: {shapes: {disk: {circle: {center: [0, 0], radius: 1}}}, domain: disk}\n"
      "discretization: {basis: {bspline: 3, cells: 10}}\n"
      "physics: {type: custom, unknowns: [u], " +
      physics + "}\nconditions: [{at: disk, value: x}]\n";
  return test::solved(text, overrides);
}

TEST(ScalarLinear, FormulasWithoutUnknownsInTheirTangentsAreLinearByForm) {
  const ScalarSolution solution = solved_on_disk("energy: (dx(u)^2 + dy(u)^2)/2 - exp(x)*u");
  EXPECT_EQ(solution.linearity, Linearity::by_form);
  EXPECT_TRUE(solution.newton.empty());
}

TEST(ScalarLinear, TermsThatCancelAreLinearByValueAndNeedOneSystem) {
  const ScalarSolution plain = solved_on_disk("energy: (dx(u)^2 + dy(u)^2)/2 + u^2/2 - exp(x)*u");
  for (const char* energy : {"(dx(u)^2 + dy(u)^2)/2 + u^2/2 + u^4 - u^2*u^2 - exp(x)*u",
                             "(cos(u)^2 + sin(u)^2)*(dx(u)^2 + dy(u)^2)/2 + u^2/2 - exp(x)*u"}) {
    const ScalarSolution solution = solved_on_disk(std::string("energy: ") + energy);
    EXPECT_EQ(solution.linearity, Linearity::by_value) << energy;
    EXPECT_TRUE(solution.newton.empty());
    EXPECT_LT(difference(solution, plain), 1e-11);
    EXPECT_NEAR(*solution.energy, *plain.energy, 1e-9 * *plain.energy);
  }
}

TEST(ScalarLinear, ResidualsThatCancelAreLinearByValueByEveryMethod) {
  const std::string residual = "laplacian(u) + exp(x)";
  for (const char* method :
       {"{method: least_squares}", "{method: least_squares, solver: {factorization: qr}}",
        "{method: collocation}", "{method: collocation, solver: {points: greville}}"}) {
    const std::string text(method);
    std::vector<std::string> overrides{"discretization=" + text.substr(0, text.size() - 1) +
                                       ", basis: {bspline: 3, cells: 10}}"};
    const ScalarSolution plain = solved_on_disk("residuals: ['" + residual + "']", overrides);
    const ScalarSolution solution =
        solved_on_disk("residuals: ['" + residual + " + u^3 - u*u*u']", overrides);
    EXPECT_EQ(plain.linearity, Linearity::by_form) << method;
    EXPECT_EQ(solution.linearity, Linearity::by_value) << method;
    EXPECT_TRUE(solution.newton.empty());
    EXPECT_LT(difference(solution, plain), 1e-10) << method;
    EXPECT_EQ(solved_on_disk("residuals: ['" + residual + " + u^3']", overrides).linearity,
              Linearity::none);
  }
}

TEST(ScalarLinear, WhatIsNonlinearOnlyAtTheSolutionIsFoundThere) {
  // −Δu + max(u − 1000, 0) = 16000, whose solution is 4000 (1 − r²) + x without the term: states at
  // random do not come that far.
  const std::string threshold =
      "weak: 'dx(u)*dx(test(u)) + dy(u)*dy(test(u)) + 20*max(u - 1000, 0)*test(u) - load*test(u)'";
  const auto with_load = [&](const std::string& load) {
    return solved_on_disk("coefficients: {load: " + load + "}, " + threshold);
  };
  const ScalarSolution low = with_load("1000");
  EXPECT_EQ(low.linearity, Linearity::by_value);
  EXPECT_TRUE(low.newton.empty());
  const ScalarSolution high = with_load("16000");
  EXPECT_EQ(high.linearity, Linearity::none);
  EXPECT_GT(high.newton.size(), 2u);
  EXPECT_LT(norms(high.results.unknowns[0].field, high.rule).maximum, 2000);
}

TEST(ScalarLinear, NonlinearEquationsAreSaidToBe) {
  const ScalarSolution solution =
      solved_on_disk("weak: (1 + u^2)*(dx(u)*dx(test(u)) + dy(u)*dy(test(u))) - test(u)");
  EXPECT_EQ(solution.linearity, Linearity::none);
  EXPECT_GT(solution.newton.size(), 2u);
}

// Dry friction on a membrane: −Δu + 3 sign(u) = 4 with u = 0 on the circle, hence −Δu = 1.
TEST(ScalarLinear, EquationsThatJumpInTheUnknownAreNotLinear) {
  const auto solved = [](const std::string& force) {
    return solved_on_disk("weak: 'dx(u)*dx(test(u)) + dy(u)*dy(test(u)) - (" + force + ")*test(u)'",
                          {"conditions.0.value=0"});
  };
  const ScalarSolution known = solved("1");
  for (const char* force : {"4 - 3*sign(u)", "4 - if(u > 0, 3, 0)"}) {
    const ScalarSolution solution = solved(force);
    EXPECT_EQ(solution.linearity, Linearity::none) << force;
    EXPECT_LT(difference(solution, known), 1e-12) << force;
  }
}

}  // namespace
