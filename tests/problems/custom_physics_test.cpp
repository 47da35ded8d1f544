#include "problems/custom_physics.hpp"

#include <gmock/gmock.h>

#include "tests/problems/solved_text.hpp"

using namespace rfm;
using namespace rfm::test;

namespace {

// A disk with a hole, values on the disk by structure and on an arc of the hole weakly.
std::string problem_with(const std::string& physics, const std::string& hole) {
  return "dimension: 2\n"
         "fields: {f: exp(x)*cos(y), k: 1 + x^2/2}\n"
         "geometry:\n"
         "  shapes:\n"
         "    disk: {circle: {center: [0, 0], radius: 1}}\n"
         "    hole: {circle: {center: [0.1, 0], radius: 0.4}}\n"
         "  domain: disk - hole\n"
         "regions: {arc: {of: hole, where: y}}\n"
         "discretization: {basis: {bspline: 3, cells: 12}}\n"
         "physics: " +
         physics +
         "\nconditions:\n"
         "  - {at: disk, value: sin(3*x) + y}\n"
         "  - {at: arc, value: x}\n"
         "  - {at: rest, " +
         hole + "}\n";
}

const std::string built_in =
    problem_with("{type: poisson, diffusivity: k, reaction: 2, source: f}", "flux: 1 + x");

TEST(CustomPhysics, EnergyOfPoissonIsTheBuiltInEquation) {
  const ScalarSolution custom = solved(
      problem_with("{type: custom, unknowns: [w], energy: k/2*(dx(w)^2 + dy(w)^2) + w^2 - f*w,"
                   " boundary: [{at: hole, energy: -(1 + x)*w}]}",
                   "free: true"));
  const ScalarSolution other = solved(
      problem_with("{type: poisson, diffusivity: k, reaction: 2, source: f}", "flux: 1 + x"));
  // Its flux is prescribed on the arc too, where the value is: both forms of the arc differ by
  // that.
  EXPECT_GT(difference(custom, other), 1e-6);
  const ScalarSolution part = solved(
      problem_with("{type: custom, unknowns: [w], energy: k/2*(dx(w)^2 + dy(w)^2) + w^2 - f*w,"
                   " boundary: [{at: hole, energy: -(1 + x)*step(-y)*w}]}",
                   "free: true"));
  EXPECT_LT(difference(part, other), 1e-13);
  EXPECT_EQ(part.linear.method, other.linear.method);
}

TEST(CustomPhysics, WeakFormOfPoissonIsTheBuiltInEquation) {
  const ScalarSolution custom = solved(
      problem_with("{type: custom, unknowns: [w], weak: k*dx(w)*dx(test(w)) + k*dy(w)*dy(test(w))"
                   " + (2*w - f)*test(w), boundary: [{at: hole, weak: -(1 + x)*step(-y)*test(w)}]}",
                   "free: true"));
  EXPECT_EQ(custom.linear.method, LinearSolution::Method::lu);
  EXPECT_LT(difference(custom, solved(built_in)), 1e-11);
}

TEST(CustomPhysics, GalerkinsMethodHasTheSolutionOfRitz) {
  const ScalarSolution galerkin = solved(built_in, {"discretization.method=galerkin"});
  const ScalarSolution ritz = solved(built_in);
  EXPECT_EQ(galerkin.linear.method, LinearSolution::Method::lu);
  EXPECT_LT(difference(galerkin, ritz), 1e-11);
  EXPECT_NEAR(*galerkin.energy, *ritz.energy, 1e-9 * *ritz.energy);
}

TEST(CustomPhysics, ACoefficientThatOnlySeemsToDependOnTheSolutionIsLinear) {
  const ScalarSolution solution = solved(
      problem_with("{type: poisson, diffusivity: k + 0*u, reaction: 2, source: f}", "flux: 1 + x"));
  EXPECT_LT(difference(solution, solved(built_in)), 1e-11);
}

TEST(CustomPhysics, ResidualsOfPoissonConvergeToItsSolution) {
  // −Δu = f with u known: least squares lose two orders in the energy and none in u for p = 4.
  const std::string text =
      "dimension: 2\n"
      "fields: {exact: sin(2*x)*exp(y) + x*y}\n"
      "geometry: {shapes: {disk: {circle: {center: [0, 0], radius: 1}}}, domain: disk}\n"
      "discretization: {basis: {bspline: 4, cells: 12}}\n"
      "physics: {type: custom, unknowns: [u], residuals: [\"laplacian(u) - laplacian(exact)\"]}\n"
      "conditions: [{at: disk, value: \"exact + (1 - x^2 - y^2)*cos(y)\"}]\n";
  const ScalarSolution solution = solved(text);
  const Field x = x_coordinate(), y = y_coordinate();
  EXPECT_LT(
      norms(solution.results.unknowns[0].field - (sin(2.0 * x) * exp(y) + x * y), solution.rule)
          .maximum,
      1e-5);
  EXPECT_FALSE(solution.energy);
}

}  // namespace
