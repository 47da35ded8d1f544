#include "solvers/refined_splines.hpp"

#include <gmock/gmock.h>

#include <cmath>

#include "core/error.hpp"
#include "core/tape.hpp"
#include "tests/solvers/sample_problems.hpp"

namespace rfm {
namespace {

using namespace test;

const std::vector<double> coarse_lines{0, 0.2, 0.5, 0.6, 1};
const std::vector<double> fine_lines{0, 0.05, 0.1, 0.2, 0.35, 0.5, 0.55, 0.6, 0.9, 1};

std::vector<std::vector<double>> in_plane(const std::vector<double>& lines) {
  return {lines, lines};
}

Eigen::VectorXd some_coefficients(Eigen::Index count) {
  Eigen::VectorXd result(count);
  for (Eigen::Index i = 0; i < count; ++i)
    result[i] = std::sin(3.7 * static_cast<double>(i * i) + 1);
  return result;
}

class EveryRefinedDegree : public testing::TestWithParam<int> {};
INSTANTIATE_TEST_SUITE_P(RefinedSplines, EveryRefinedDegree, testing::Values(1, 2, 3, 5, 8));

TEST_P(EveryRefinedDegree, AreTheSameFunctionsOnTheFinerGrid) {
  const int degree = GetParam();
  const std::vector<TensorProductSpace> own{{Grid::with_lines(in_plane(coarse_lines)), degree}},
      common{{Grid::with_lines(in_plane(fine_lines)), degree}};
  const SplineExtraction splines = refined_splines(own, common);
  const Eigen::VectorXd y = some_coefficients(own[0].size());
  const std::vector<Structure> structures{Structure::undetermined()};
  const Field coarse = solution_fields(structures, own, y)[0],
              fine = solution_fields(structures, common, splines.matrix * y)[0];
  const Tape tape({coarse - fine, partial(coarse - fine, 0)}, {0, 0}, 2);
  for (double a = 0.01; a < 1; a += 0.07)
    for (double b = 0.02; b < 1; b += 0.09) {
      EXPECT_NEAR(tape.value({a, b}, 0), 0, 1e-13);
      EXPECT_NEAR(tape.value({a, b}, 1), 0, 1e-11);
    }
  // As functions: of degree 8 the outermost splines hardly reach into the box.
  const Eigen::VectorXd c = splines.matrix * y;
  EXPECT_LT((splines.matrix * splines.reduced(c) - c).norm(), 1e-11);
}

TEST_P(EveryRefinedDegree, OfAWindowAreTheSameWithinItsBox) {
  const int degree = GetParam();
  const std::vector<double> window{0.2, 0.35, 0.5, 0.55, 0.6};
  const std::vector<TensorProductSpace> own{{Grid::with_lines(in_plane(window)), degree}},
      common{{Grid::with_lines(in_plane(fine_lines)), degree}};
  const SplineExtraction splines = refined_splines(own, common);
  const Eigen::VectorXd y = some_coefficients(own[0].size());
  const std::vector<Structure> structures{Structure::undetermined()};
  const Tape tape({solution_fields(structures, own, y)[0] -
                   solution_fields(structures, common, splines.matrix * y)[0]},
                  {0}, 2);
  for (double a = 0.2; a <= 0.6; a += 0.05)
    for (double b = 0.2; b <= 0.6; b += 0.03) EXPECT_NEAR(tape.value({a, b}), 0, 1e-12);
}

TEST(RefinedSplines, AreAPartitionOfUnityInSpace) {
  const std::vector<std::vector<double>> coarse{{0, 1, 2}, {0, 1}, {0, 2, 3}},
      fine{{0, 0.5, 1, 2}, {0, 0.25, 0.5, 1}, {0, 1, 2, 3}};
  const std::vector<TensorProductSpace> own{{Grid::with_lines(coarse), 2}},
      common{{Grid::with_lines(fine), 2}};
  const SplineExtraction splines = refined_splines(own, common);
  const Eigen::VectorXd ones = splines.matrix * Eigen::VectorXd::Ones(own[0].size());
  EXPECT_LT((ones - Eigen::VectorXd::Ones(common[0].size())).norm(), 1e-12);
  EXPECT_EQ(splines.first, (std::vector<Eigen::Index>{0, own[0].size()}));
}

TEST(RefinedSplines, RefuseALineThatIsMissing) {
  const std::vector<TensorProductSpace> own{{Grid::with_lines(in_plane({0, 0.3, 1})), 2}},
      common{{Grid::with_lines(in_plane(fine_lines)), 2}}, other{{own[0].grid(), 3}};
  EXPECT_THROW(refined_splines(own, common), InvalidArgument);
  EXPECT_THROW(refined_splines(own, other), InvalidArgument);
}

// ½ |u'|² + ½ u² − f u, assembled with coarse splines, or with fine ones and folded.
TEST(RefinedSplines, GiveTheSystemOfTheCoarseGrid) {
  const Region square = unit_box(2);
  const Grid coarse(Box{2, {0, 0, 0}, {1, 1, 0}}, {4, 4, 1}),
      fine(Box{2, {0, 0, 0}, {1, 1, 0}}, {8, 8, 1});
  const Field x = x_coordinate(), y = y_coordinate();
  const std::vector<Contribution> parts{{diffusion(2, 1 + x * y, 1.0, x * x * y)}};
  const std::vector<Structure> structures{Structure::undetermined()};
  const std::vector<TensorProductSpace> own{{coarse, 3}}, common{{fine, 3}};
  const LinearSystem expected = assemble(structures, own, parts, rule_for(square, coarse, 4));
  const LinearSystem folded =
      refined_splines(own, common)
          .folded(assemble(structures, common, parts, rule_for(square, fine, 4)));
  EXPECT_LT(SparseMatrix(expected.matrix - folded.matrix).norm(), 1e-13);
  EXPECT_LT((expected.right_hand_side - folded.right_hand_side).norm(), 1e-14);
}

}  // namespace
}  // namespace rfm
