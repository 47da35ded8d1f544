#include "problems/residual_check.hpp"

#include <gmock/gmock.h>

#include "tests/problems/solved_text.hpp"

namespace rfm {
namespace {

// Stokes' equations between walls by residuals, with sources of strength q.
std::vector<std::string> warnings(const std::string& q, const std::string& discretization) {
  const ScalarSolution solution = test::solved(
      "dimension: 2\n"
      "geometry: {shapes: {disk: {circle: {center: [0, 0], radius: 1}}}, domain: disk}\n"
      "physics:\n  type: custom\n  unknowns: [u, v, p]\n"
      "  residuals: [\"dx(p) - laplacian(u) - y\", \"dy(p) - laplacian(v) + x\", \"dx(u) + dy(v) "
      "- " +
      q +
      "\"]\n"
      "conditions: [{at: disk, value: {u: 0, v: 0}}]\n"
      "discretization: " +
      discretization + "\n");
  std::vector<std::string> warnings;
  for (const std::string& note : solution.notes)
    if (note.starts_with("warning")) warnings.push_back(note);
  return warnings;
}

class ResidualCheck : public testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(EveryWay, ResidualCheck,
                         testing::Values("{method: least_squares, basis: {bspline: 3, cells: 10}}",
                                         "{method: collocation, basis: {bspline: 3, cells: 10}}",
                                         "{method: least_squares, basis: {legendre: 8}}"));

TEST_P(ResidualCheck, TellsOfEquationsThatContradictTheConditions) {
  EXPECT_THAT(warnings("0", GetParam()), testing::IsEmpty());
  EXPECT_THAT(warnings("x", GetParam()), testing::IsEmpty());  // whose integral is 0
  for (const char* q : {"1", "1e-3"})
    EXPECT_THAT(warnings(q, GetParam()),
                testing::Contains(testing::HasSubstr("residual 3 is left at 1 of its loads")))
        << q;
}

}  // namespace
}  // namespace rfm
