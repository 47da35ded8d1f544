// What windows gain: freedom where the solution needs it, at a cost that is local.

#include "problems/windows.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <filesystem>

#include "core/tape.hpp"
#include "problems/reader.hpp"
#include "problems/scalar_problem.hpp"
#include "problems/verification.hpp"

namespace rfm {
namespace {

using Overrides = std::vector<std::string>;

const std::filesystem::path structures =
    std::filesystem::path(RFM_VERIFICATION_FOLDER) / "structures";

struct Solved {
  int unknowns = 0;
  double l2 = 0, h1 = 0, smallest_eigenvalue = 0, boundary_residual = 0;
  std::optional<double> undetermined;
  Field u = 0.0;
};

Solved solved(const std::string& name, const Overrides& overrides = {}) {
  const Problem file = read_problem((structures / (name + ".yaml")).string(), overrides);
  const ScalarProblem problem(file);
  const Grid grid = problem.grid();
  const ScalarSolution solution = problem.solve(grid);
  const SolutionErrors errors = solution_errors(problem, grid, solution)->all;
  return {solution.unknowns,
          errors.l2_relative,
          errors.h1_relative,
          solution.linear.smallest_eigenvalue,
          solution.boundary_residual,
          solution.undetermined,
          solution.results.unknowns[0].field};
}

// The file without its windows, whose shapes a probe names instead.
Solved plain(const std::string& name, int cells, const Overrides& shapes) {
  Overrides overrides{"windows=[]", "discretization.basis.cells=" + std::to_string(cells)};
  for (const std::string& shape : shapes)
    overrides.push_back("probes." + shape + "_={average: u, over: " + shape + "}");
  return solved(name, overrides);
}

TEST(Windows, OfAPeakReduceTheErrorAtEqualUnknowns) {
  const Solved with = solved("window_peak"), without = plain("window_peak", 32, {"lens"});
  EXPECT_NEAR(with.unknowns, without.unknowns, 0.01 * with.unknowns);
  EXPECT_THAT(without.h1 / with.h1, testing::AllOf(testing::Gt(15), testing::Lt(30)));
  EXPECT_THAT(without.l2 / with.l2, testing::AllOf(testing::Gt(40), testing::Lt(90)));
}

// Splines of domain and window describe nearly the same where the window's factor is smooth.
TEST(Windows, LeaveTheSystemWellEnoughConditioned) {
  const Solved global = solved("window_peak");
  EXPECT_GT(global.smallest_eigenvalue, 1e-11);
  EXPECT_LT(*global.undetermined, 1e-10);
}

// A window all over the domain, of the domain's own splines: many functions are there twice.
TEST(Windows, OfDependentFunctionsDoNoHarm) {
  const Overrides all{"geometry.shapes.lens={circle: {center: [0, 0], radius: 4}}",
                      "windows.0.basis={cells: 8, bspline: 1}", "discretization.basis.bspline=5"};
  const Solved global = solved("window_peak", all);
  EXPECT_LT(global.smallest_eigenvalue, 1e-12);
  EXPECT_LT(*global.undetermined, 1e-8);
  Overrides without = all;
  without.back() = "windows=[]";
  without.emplace_back("discretization.basis.bspline=5");
  without.emplace_back("probes.p={average: u, over: lens}");
  without.erase(without.begin() + 1);
  const Solved domain = solved("window_peak", without);
  EXPECT_LT(global.h1, 1.01 * domain.h1);
}

TEST(Windows, NestedAtACornerReduceTheErrorAtEqualUnknowns) {
  const Solved with = solved("window_at_a_corner"),
               without = plain("window_at_a_corner", 38, {"near", "nearer", "nearest"});
  EXPECT_NEAR(with.unknowns, without.unknowns, 0.05 * with.unknowns);
  EXPECT_THAT(without.h1 / with.h1, testing::AllOf(testing::Gt(2), testing::Lt(3)));
  EXPECT_THAT(without.l2 / with.l2, testing::AllOf(testing::Gt(4), testing::Lt(10)));
  EXPECT_LT(with.boundary_residual, 1e-10);
}

TEST(Windows, AtTheBoundaryKeepTheCondition) {
  EXPECT_LT(solved("window_at_boundary").boundary_residual, 1e-10);
}

TEST(Windows, AreSolvedLocallyWithTheSolutionOfTheDomainFixed) {
  // Cells of the domain are integrated as well as those of the window.
  const Solved domain = solved("window_peak", {"windows=[]", "discretization.quadrature.order=20",
                                               "probes.p={average: u, over: lens}"}),
               local = solved("window_peak", {"windows.0.solve=local"}),
               global = solved("window_peak");
  EXPECT_EQ(local.unknowns, global.unknowns);
  const Tape tape({local.u - domain.u}, {0}, 2);
  double inside = 0;
  for (double angle = 0; angle < 6; angle += 0.3) {
    const double x = std::cos(angle), y = std::sin(angle);
    EXPECT_NEAR(tape.value({0.2 + 0.41 * x, 0.1 + 0.41 * y}), 0, 1e-8);
    inside = std::max(inside, std::fabs(tape.value({0.2 + 0.1 * x, 0.1 + 0.1 * y})));
  }
  EXPECT_GT(inside, 1e-3);
  // In the norm of the energy, which here is that of H1.
  EXPECT_LT(local.h1, 0.5 * domain.h1);
  EXPECT_LT(global.h1, 0.5 * local.h1);
}

TEST(Windows, GiveTheSameByEveryMethodOfOneSystem) {
  const Solved ritz = solved("window_peak");
  EXPECT_NEAR(solved("window_peak", {"discretization.method=galerkin"}).h1, ritz.h1,
              1e-4 * ritz.h1);
  EXPECT_LT(solved("window_peak", {"discretization.method=least_squares"}).h1, 1.5 * ritz.h1);
}

TEST(Windows, HaveCellsThatArePartsOfThoseOfTheDomain) {
  const Problem file = read_problem((structures / "window_at_a_corner.yaml").string(), {});
  const ScalarProblem problem(file);
  const Grid grid = problem.grid(), common = common_grid(grid, problem.windows());
  int finer = 1;
  for (const Window& window : problem.windows()) {
    finer *= 2;
    EXPECT_EQ(window.finer, finer);
    const Grid own = window_grid(window, grid);
    for (int axis = 0; axis < 2; ++axis)
      for (int i = 0; i <= own.cells(axis); ++i) {
        const int cell = common.locate(axis, own.line(axis, i));
        EXPECT_TRUE(common.line(axis, cell) == own.line(axis, i) ||
                    common.line(axis, cell + 1) == own.line(axis, i));
      }
  }
}

}  // namespace
}  // namespace rfm
