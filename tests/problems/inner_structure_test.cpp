// What conditions inside the domain and singular functions gain, and what remains open where a
// condition is missing.

#include "problems/inner_structure.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <filesystem>

#include "core/evaluate.hpp"
#include "problems/reader.hpp"
#include "problems/scalar_problem.hpp"
#include "problems/verification.hpp"

using namespace rfm;

namespace {

const std::filesystem::path structures =
    std::filesystem::path(RFM_VERIFICATION_FOLDER) / "structures";

ScalarSolution solved(const Problem& file) {
  const ScalarProblem problem(file);
  return problem.solve(problem.grid());
}

ScalarSolution solved(const std::string& name, const std::vector<std::string>& overrides = {}) {
  return solved(read_problem((structures / (name + ".yaml")).string(), overrides));
}

TEST(Enrichment, OfMotzProblemIsAThousandTimesBetterAtEqualUnknowns) {
  const double truth = 330.75528394633818;  // at (½, ½), from the series
  const auto error = [&](const ScalarSolution& solution) {
    return std::fabs(value_at(solution.results.unknowns[0].field, {0.5, 0.5}) - truth);
  };
  const ScalarSolution with = solved("motz_enriched");
  const ScalarSolution without =
      solved("motz_enriched", {"enrich=[]", "discretization.basis.cells=40"});
  EXPECT_GE(without.unknowns, with.unknowns);
  EXPECT_LT(error(with), 1e-6 * truth);
  EXPECT_GT(error(without), 1000 * error(with));
}

TEST(Interface, WithoutItTheKinkIsLost) {
  const auto error = [&](const std::vector<std::string>& overrides) {
    const Problem file = read_problem((structures / "interface.yaml").string(), overrides);
    const ScalarProblem problem(file);
    const Grid grid = problem.grid();
    return solution_errors(problem, grid, problem.solve(grid))->all.l2_relative;
  };
  const double with = error({});
  EXPECT_LT(with, 1e-4);
  EXPECT_GT(error({"conditions=[{at: inner, value: 1}, {at: outer, value: 0}]"}), 30 * with);
}

std::vector<std::string> remarks_of(const std::string& name,
                                    const std::vector<std::string>& overrides = {}) {
  const Problem file = read_problem((structures / (name + ".yaml")).string(), overrides);
  return ScalarProblem(file).dirichlet()[0].remarks;
}

TEST(Interface, IsMissedWhereTheConductivityJumps) {
  const auto says_so = testing::Contains(testing::HasSubstr("conductivity changes"));
  EXPECT_THAT(remarks_of("interface"), testing::Not(says_so));
  EXPECT_THAT(
      remarks_of("interface", {"conditions=[{at: inner, value: 1}, {at: outer, value: 0}]"}),
      says_so);
}

TEST(Remainder, ThatChangesItsSignInsideIsTold) {
  const auto says_so = testing::Contains(testing::HasSubstr("changes its sign"));
  EXPECT_THAT(remarks_of("remainder"), testing::Not(says_so));
  const auto of = [](const std::string& remainder) {
    const Problem file = read_problem(make_source(
        "remainder.yaml",
        "dimension: 2\n"
        "geometry: {shapes: {disk: {circle: {center: [0, 0], radius: 1}}}, domain: disk}\n"
        "physics: {type: poisson, source: 1}\n"
        "conditions: [{at: disk, value: 0}]\n"
        "discretization: {basis: {cells: 8}}\n"
        "remainder: " +
            remainder + "\n"));
    return ScalarProblem(file).dirichlet()[0].remarks;
  };
  EXPECT_THAT(of("(1 - x^2 - y^2)*(x - 0.5)"), says_so);
  EXPECT_THAT(of("(1 - x^2 - y^2)*(x - 2)"), testing::Not(says_so));
}

// A disk, on whose edge ω² Ψ2 vanishes and nothing is prescribed.
std::string disk(const std::string& energy) {
  return "dimension: 2\n"
         "geometry: {shapes: {disk: {circle: {center: [0, 0], radius: 1}}}, domain: disk}\n"
         "physics: {type: custom, unknowns: [u], energy: '" +
         energy +
         "'}\n"
         "conditions: [{at: disk, free: true}]\n"
         "discretization:\n"
         "  basis: {bspline: 3, cells: 8}\n"
         "  structure: psi1 + omega(disk)^2*psi2\n";
}

TEST(Undetermined, IsAFunctionOfTheSizeOfTheSolutionWhereAConditionIsMissing) {
  // Nothing fixes the level of u; the load is balanced.
  const ScalarSolution open =
      solved(read_problem(make_source("open.yaml", disk("(dx(u)^2 + dy(u)^2)/2 - x*u"))));
  ASSERT_TRUE(open.undetermined);
  EXPECT_GT(*open.undetermined, 1e-3);
}

TEST(Undetermined, IsNothingWhereTwoFunctionsMerelyDescribeTheSame) {
  const ScalarSolution closed =
      solved(read_problem(make_source("closed.yaml", disk("(dx(u)^2 + dy(u)^2 + u^2)/2 - x*u"))));
  ASSERT_TRUE(closed.undetermined);
  EXPECT_LT(*closed.undetermined, 1e-5);
}

TEST(Undetermined, IsNotAskedOfASingleFunction) {
  EXPECT_FALSE(solved("motz_enriched", {"enrich=[]"}).undetermined);
}

}  // namespace
