#include "solvers/ritz.hpp"

#include <gmock/gmock.h>

#include <cmath>

#include "core/error.hpp"
#include "solution_structures/dirichlet.hpp"
#include "tests/solvers/sample_problems.hpp"

namespace rfm {
namespace {

using namespace test;
const Field x = x_coordinate(), y = y_coordinate();

double relative_error(int degree, int cells) {
  const Field exact = sin(2 * x) * exp(y);
  const DiscretizedRegion domain(circle({0, 0}, 1) - circle({0.2, 0.1}, 0.4),
                                 {.cells = cells, .degree = degree});
  const Field omega = domain.weight().function;
  const Contribution energy{diffusion(2, 1, 0, -laplacian(exact, 2))};
  const Field u = minimize({energy}, dirichlet(exact + omega * cos(3 * x + y), omega), domain).u;
  return norms(u - exact, domain.rule()).l2 / norms(exact, domain.rule()).l2;
}

class Ritz : public testing::TestWithParam<int> {};
INSTANTIATE_TEST_SUITE_P(EveryDegree, Ritz, testing::Values(1, 2, 3, 4));

TEST_P(Ritz, ConvergesWithTheOrderOfItsSplines) {
  const int degree = GetParam();
  EXPECT_NEAR(std::log2(relative_error(degree, 16) / relative_error(degree, 32)), degree + 1, 0.4);
}

TEST(DiscretizedRegion, HasTheMeasuresOfItsRegion) {
  const DiscretizedRegion ring(circle({0, 0}, 1) - circle({0.2, 0.1}, 0.4), {.cells = 32});
  EXPECT_NEAR(ring.rule().measure(), M_PI * 0.84, 1e-11);
  EXPECT_NEAR(ring.rule().boundary_measure(), M_PI * 2.8, 1e-10);
  EXPECT_EQ(ring.grid().cells(0), 32);
  EXPECT_EQ(ring.space().degree(), 3);
  EXPECT_EQ(ring.weight().formula.find("r0"), std::string::npos) << "the circles do not meet";
}

TEST(DiscretizedRegion, TakesAnotherBoxForItsGrid) {
  const DiscretizationOptions options{.cells = 10, .degree = 2, .grid = Box{2, {-2, -3}, {3, 2}}};
  const DiscretizedRegion disk(circle({0, 0}, 1), options);
  EXPECT_EQ(disk.grid().spacing(0), 0.5);
  EXPECT_NEAR(disk.rule().measure(), M_PI, 1e-6);
}

TEST(DiscretizedRegion, RegionsThatAreEmptyOrUnboundedAreRefused) {
  EXPECT_THROW(DiscretizedRegion(circle({0, 0}, 1) & circle({3, 0}, 1)), InvalidArgument);
  EXPECT_THROW(DiscretizedRegion(half_plane({0, 0}, {1, 0})), InvalidArgument);
}

TEST(Minimize, RefusesStructuresOfSeveralUndeterminedFunctions) {
  const DiscretizedRegion disk(circle({0, 0}, 1), {.cells = 4, .degree = 1});
  const Structure two = Structure::undetermined(0) + Structure::undetermined(1);
  EXPECT_THROW(minimize({Contribution{diffusion(2, 1, 1, 0)}}, two, disk), InvalidArgument);
}

}  // namespace
}  // namespace rfm
