#include "core/grid_splines.hpp"

#include <gmock/gmock.h>

#include <cmath>

#include "core/error.hpp"

namespace rfm {
namespace {

// Cells of widths 1, 0.01, 3, 0.5 and 0.5.
const std::vector<double> uneven[] = {{-2, -1, -0.99, 2.01, 2.51, 3.01}};
const Grid grid = Grid::with_lines(uneven);

class GridSplinesOfDegree : public testing::TestWithParam<int> {};
INSTANTIATE_TEST_SUITE_P(GridSplines, GridSplinesOfDegree, testing::Range(0, 9));
// Of degree 0 splines are constants that jump.
class SmoothGridSplinesOfDegree : public GridSplinesOfDegree {};
INSTANTIATE_TEST_SUITE_P(GridSplines, SmoothGridSplinesOfDegree,
                         testing::Range(1, maximum_spline_degree + 1));

// B by its definition as a divided difference: the recurrence over the whole line.
double by_definition(int degree, int spline, double x) {
  const double from = grid.knot(0, spline - degree), to = grid.knot(0, spline + 1);
  if (degree == 0) return x >= from && x < to ? 1 : 0;
  const double inner_to = grid.knot(0, spline), inner_from = grid.knot(0, spline - degree + 1);
  return (x - from) / (inner_to - from) * by_definition(degree - 1, spline - 1, x) +
         (to - x) / (to - inner_from) * by_definition(degree - 1, spline, x);
}

TEST_P(GridSplinesOfDegree, AreThoseOfCoxAndDeBoor) {
  const int degree = GetParam();
  std::vector<double> values(degree + 1);
  for (int cell = 0; cell < grid.cells(0); ++cell)
    for (const double s : {0.0, 0.3, 0.99}) {
      evaluate_bsplines(grid, 0, cell, degree, 0, s, values.data());
      for (int i = 0; i <= degree; ++i) {
        EXPECT_GE(values[i], 0);
        EXPECT_NEAR(values[i],
                    by_definition(degree, cell + i, grid.line(0, cell) + s * grid.width(0, cell)),
                    1e-13);
      }
    }
}

TEST_P(GridSplinesOfDegree, OfEqualCellsAreTheUniformOnes) {
  const int degree = GetParam(), count = degree + 1;
  const Grid uniform({1, {0}, {3.5}}, {7, 1, 1});
  std::vector<double> lines;
  for (int i = 0; i <= 7; ++i) lines.push_back(uniform.line(0, i));
  const Grid same = Grid::with_lines(std::vector<std::vector<double>>{lines});
  std::vector<double> expected(count * (degree + 3)), found(expected.size());
  for (const double s : {0.0, 0.4, 1.0}) {
    evaluate_bsplines(degree, degree + 2, s, expected.data());
    for (int cell = 0; cell < 7; ++cell) {
      evaluate_bsplines(uniform, 0, cell, degree, degree + 2, s, found.data());
      EXPECT_EQ(found, expected);
      evaluate_bsplines(same, 0, cell, degree, degree + 2, s, found.data());
      for (std::size_t i = 0; i < found.size(); ++i) EXPECT_NEAR(found[i], expected[i], 1e-12) << i;
    }
  }
}

TEST_P(SmoothGridSplinesOfDegree, JoinSmoothlyAcrossCellsOfAnySize) {
  const int degree = GetParam(), count = degree + 1;
  std::vector<double> left(count * degree), right(left.size());
  for (int cell = 0; cell + 1 < grid.cells(0); ++cell) {
    evaluate_bsplines(grid, 0, cell, degree, degree - 1, 1, left.data());
    evaluate_bsplines(grid, 0, cell + 1, degree, degree - 1, 0, right.data());
    for (int k = 0; k < degree; ++k) {
      double size = 1;
      for (int i = 0; i < count; ++i) size = std::max(size, std::abs(left[k * count + i]));
      EXPECT_NEAR(left[k * count], 0, 1e-12 * size);
      EXPECT_NEAR(right[k * count + degree], 0, 1e-12 * size);
      for (int i = 0; i < degree; ++i)
        EXPECT_NEAR(left[k * count + i + 1], right[k * count + i], 1e-12 * size) << k;
    }
  }
}

TEST_P(SmoothGridSplinesOfDegree, AreAccurateRelativeToTheirOwnSizeAtTheEndsOfTheirSupport) {
  const int degree = GetParam();
  std::vector<double> values(degree + 1);
  for (int cell = 0; cell < grid.cells(0); ++cell) {
    // (x − t)^p / Π (t_j − t) over the further knots.
    double limit = 1;
    for (int j = 1; j <= degree; ++j)
      limit *= grid.width(0, cell) / (grid.knot(0, cell + j) - grid.knot(0, cell));
    for (const double s : {1e-30, 1e-12}) {
      evaluate_bsplines(grid, 0, cell, degree, 0, s, values.data());
      EXPECT_NEAR(values[degree] / (limit * std::pow(s, degree)), 1, 1e-10);
    }
  }
}

TEST_P(GridSplinesOfDegree, HaveBernsteinCoefficientsAndDerivativesOfOneDegreeLess) {
  const int degree = GetParam();
  const double low = 0.2, high = 0.7;
  std::vector<double> values(2 * (degree + 1)), lower(degree + 1);
  for (int cell = 0; cell < grid.cells(0); ++cell) {
    const BlossomMatrix bernstein = bernstein_from_bsplines(grid, 0, cell, degree, low, high);
    const BlossomMatrix slopes = derivative_coefficients(grid, 0, cell, degree);
    for (const double t : {0.0, 0.6, 1.0}) {
      const double s = low + t * (high - low);
      evaluate_bsplines(grid, 0, cell, degree, 1, s, values.data());
      if (degree > 0) evaluate_bsplines(grid, 0, cell, degree - 1, 0, s, lower.data());
      for (int i = 0; i <= degree; ++i) {
        double sum = 0, binomial = 1, slope = 0;
        for (int k = 0; k <= degree; ++k) {
          EXPECT_GE(bernstein[k][i], -1e-15);
          sum += bernstein[k][i] * binomial * std::pow(t, k) * std::pow(1 - t, degree - k);
          binomial *= double(degree - k) / (k + 1);
        }
        EXPECT_NEAR(sum, values[i], 1e-14);
        for (int k = 0; k < degree; ++k) slope += slopes[k][i] * lower[k];
        const double expected = values[degree + 1 + i] / grid.spacing(0);
        EXPECT_NEAR(slope, expected, 1e-12 * (1 + std::abs(expected)));
      }
    }
  }
}

TEST_P(GridSplinesOfDegree, ReproduceXWithTheirGrevillePoints) {
  const int degree = GetParam();
  if (degree == 0) {
    EXPECT_NEAR(greville_point(grid, 0, 0, 2), 0.51, 1e-15);
    return;
  }
  std::vector<double> values(degree + 1);
  for (int cell = 0; cell < grid.cells(0); ++cell) {
    evaluate_bsplines(grid, 0, cell, degree, 0, 0.3, values.data());
    double sum = 0;
    for (int i = 0; i <= degree; ++i) sum += values[i] * greville_point(grid, 0, degree, cell + i);
    EXPECT_NEAR(sum, grid.line(0, cell) + 0.3 * grid.width(0, cell), 1e-13);
  }
}

TEST(GridSplines, OfDegreesThatDoNotExistAreRefused) {
  std::vector<double> values(100);
  EXPECT_THROW(evaluate_bsplines(grid, 0, 1, 9, 0, 0.5, values.data()), InvalidArgument);
  EXPECT_THROW(evaluate_bsplines(grid, 0, 1, 3, -1, 0.5, values.data()), InvalidArgument);
}

}  // namespace
}  // namespace rfm
