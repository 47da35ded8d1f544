#include "solvers/periodic_splines.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <numbers>

#include "core/error.hpp"
#include "core/tape.hpp"
#include "tests/solvers/sample_problems.hpp"

namespace rfm {
namespace {

using namespace test;

const Field x = x_coordinate(), y = y_coordinate();
const double pi = std::numbers::pi;

// The best approximation in H1, on the unit square, of f by splines of period 1 along x.
struct PeriodicApproximation {
  PeriodicApproximation(const Field& f, int cells, int degree)
      : rule(rule_for(unit_box(2), Grid(Box{2, {0, 0, 0}, {1, 1, 0}}, {cells, cells, 1}), degree)),
        spaces{TensorProductSpace(rule.grid(), degree, cells_in_region(rule))},
        splines(periodic_splines(spaces, {true, false, false})) {
    Contribution part{diffusion(2, 1.0, 1.0, f)};
    for (int axis = 0; axis < 2; ++axis) part.energy.add_load(slope(axis), partial(f, axis));
    const std::vector<Structure> structures{Structure::undetermined()};
    const LinearSystem system = assemble(structures, spaces, std::span(&part, 1), rule);
    coefficients = splines.matrix * solve(splines.folded(system)).coefficients;
    u = solution_fields(structures, spaces, coefficients)[0];
    error = norms(u - f, rule).l2;
  }
  DomainRule rule;
  std::vector<TensorProductSpace> spaces;
  SplineExtraction splines;
  Eigen::VectorXd coefficients;
  Field u = 0.0;
  double error = 0;
};

class EveryDegree : public testing::TestWithParam<int> {};
INSTANTIATE_TEST_SUITE_P(PeriodicSplines, EveryDegree, testing::Values(1, 2, 3, 4));

TEST_P(EveryDegree, AreOneForEachCellAlongThePeriod) {
  const PeriodicApproximation own(y, 8, GetParam());
  EXPECT_EQ(own.splines.matrix.cols(), 8 * (8 + GetParam()));
  EXPECT_EQ(own.splines.matrix.rows(), (8 + GetParam()) * (8 + GetParam()));
}

TEST_P(EveryDegree, ApproximateAPeriodicFunctionAtTheOrderOfAll) {
  const Field f = exp(sin(2 * pi * x + 0.4)) * cos(y);
  const double order = std::log2(PeriodicApproximation(f, 24, GetParam()).error /
                                 PeriodicApproximation(f, 48, GetParam()).error);
  EXPECT_GT(order, GetParam() + 0.75);
  EXPECT_LT(order, GetParam() + 1.5);
}

TEST_P(EveryDegree, GoOnSmoothlyFromSideToSide) {
  const int degree = GetParam();
  const PeriodicApproximation own(exp(sin(2 * pi * x + 0.4)) * cos(y), 8, degree);
  Field derivative = own.u;
  for (int order = 0; order <= degree; ++order) {
    const Tape tape({derivative}, {0}, 2);
    const double left = tape.value({0, 0.3}), right = tape.value({1, 0.3});
    if (order < degree)
      EXPECT_NEAR(left, right, 1e-12 * std::pow(8, order)) << order;
    else  // and no more smoothly than splines do
      EXPECT_GT(std::fabs(left - right), 1e-3);
    derivative = partial(derivative, 0);
  }
}

TEST(PeriodicSplines, DoNotReachWhatIsNotPeriodic) {
  EXPECT_GT(PeriodicApproximation(x, 24, 3).error, 1e-2);
}

TEST(PeriodicSplines, AreRefusedOnFewerCellsThanTheirDegree) {
  EXPECT_NO_THROW(PeriodicApproximation(y, 3, 3));
  EXPECT_THROW(PeriodicApproximation(y, 2, 3), InvalidArgument);
}

TEST(PeriodicSplines, AreRefusedOnCellsThatAreNotEqual) {
  const std::vector<double> lines[] = {{0, 0.3, 0.6, 1}, {0, 0.5, 1}};
  const std::vector<TensorProductSpace> spaces{TensorProductSpace(Grid::with_lines(lines), 2)};
  EXPECT_THROW(periodic_splines(spaces, {true, false, false}), InvalidArgument);
}

}  // namespace
}  // namespace rfm
