#include "problems/flux_balance.hpp"

#include <gmock/gmock.h>

#include <filesystem>

#include "problems/reader.hpp"
#include "tests/problems/solved_text.hpp"

namespace rfm {
namespace {

struct Balanced {
  double imbalance = 0;
  bool is_warned = false;
};

Balanced solved(const std::string& name, const std::string& method, int cells) {
  const std::filesystem::path file =
      std::filesystem::path(RFM_VERIFICATION_FOLDER) / (name + ".yaml");
  const Problem problem = read_problem(
      file.string(),
      {"discretization.method=" + method, "discretization.basis.cells=" + std::to_string(cells)});
  const ScalarProblem scalar(problem);
  const ScalarSolution solution = scalar.solve(scalar.grid());
  Balanced result{flux_imbalance(scalar, solution).value(), false};
  for (const std::string& note : solution.notes)
    result.is_warned = result.is_warned || note.find("reentrant corner") != std::string::npos;
  return result;
}

class FluxBalance : public testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(Residuals, FluxBalance, testing::Values("least_squares", "collocation"));

// Torsion of the L: the least sum of squares gives a half of J of 0.28, and not 0.428.
TEST_P(FluxBalance, IsMissedAtAReentrantCornerHoweverFineTheGrid) {
  const Balanced coarse = solved("torsion_lshape", GetParam(), 16),
                 fine = solved("torsion_lshape", GetParam(), 32);
  EXPECT_GT(coarse.imbalance, 0.1);
  EXPECT_GT(fine.imbalance, coarse.imbalance);
  EXPECT_TRUE(coarse.is_warned && fine.is_warned);
}

TEST_P(FluxBalance, HoldsWhereTheSolutionIsSmooth) {
  for (const char* name : {"annulus_inhomogeneous", "rectangle_four_conditions", "ring_convection",
                           "structures/oblique_weakly"}) {
    const Balanced solution = solved(name, GetParam(), 24);
    EXPECT_LT(solution.imbalance, 1e-3) << name;
    EXPECT_FALSE(solution.is_warned) << name;
  }
}

TEST_P(FluxBalance, IsNotMissedByWhatBalancesOnOnePiece) {
  const ScalarSolution solution = test::solved(
      "dimension: 2\n"
      "geometry: {shapes: {disk: {circle: {center: [0, 0], radius: 1}}}, domain: disk}\n"
      "physics: {type: poisson}\n"
      "conditions: [{at: disk, flux: x}]\n"
      "discretization: {basis: {bspline: 3, cells: 8}}\n",
      {"discretization.method=" + std::string(GetParam())});
  for (const std::string& note : solution.notes)
    EXPECT_EQ(note.find("reentrant corner"), std::string::npos) << note;
  EXPECT_LT(norms(solution.results.unknowns[0].field - x_coordinate(), solution.rule).l2, 1e-10);
}

TEST(EnergyBalance, HoldsAtAReentrantCornerByTheEnergy) {
  const Balanced coarse = solved("torsion_lshape", "ritz", 16),
                 fine = solved("torsion_lshape", "ritz", 64);
  EXPECT_LT(fine.imbalance, 0.5 * coarse.imbalance);
  EXPECT_LT(fine.imbalance, 0.03);
  EXPECT_FALSE(coarse.is_warned);
}

}  // namespace
}  // namespace rfm
