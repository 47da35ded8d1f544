#include "core/grid.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <random>

#include "core/error.hpp"

namespace rfm {
namespace {

const Box oblong{2, {-1, 3}, {2, 4}};

TEST(Grid, CellsAlongTheLongestSideSetTheSpacing) {
  // 3 × 1 with 7 cells: h = 3/7, ceil(7/3) = 3 cells across, 9/7 high, centred.
  const Grid grid = Grid::with_square_cells(oblong, 7);
  EXPECT_EQ(grid.cells(0), 7);
  EXPECT_EQ(grid.cells(1), 3);
  EXPECT_EQ(grid.box().low[0], -1);
  EXPECT_EQ(grid.box().high[0], 2);
  EXPECT_NEAR(grid.box().low[1], 3.5 - 4.5 / 7, 1e-15);
  EXPECT_NEAR(grid.box().high[1], 3.5 + 4.5 / 7, 1e-15);
  EXPECT_NEAR(grid.spacing(0), grid.spacing(1), 1e-15);
}

TEST(Grid, ASideOfAWholeNumberOfCellsIsNotEnlarged) {
  for (const int cells : {3, 6, 30, 99}) {
    const Grid grid = Grid::with_square_cells(oblong, cells);
    EXPECT_EQ(grid.cells(1), cells / 3);
    EXPECT_EQ(grid.box().low[1], 3);
    EXPECT_EQ(grid.box().high[1], 4);
  }
  // 0.1 · 3 is more than 0.3: rounding makes no cell.
  const Grid grid = Grid::with_square_cells({2, {0, 0}, {0.3, 0.1 * 3}}, 10);
  EXPECT_EQ(grid.cells(0), 10);
  EXPECT_EQ(grid.cells(1), 10);
}

TEST(Grid, EveryCellFollowsTheRuleInThreeDimensions) {
  const Grid grid = Grid::with_square_cells({3, {0, 0, 0}, {1, 0.05, 0.51}}, 10);
  EXPECT_EQ(grid.cells(0), 10);
  EXPECT_EQ(grid.cells(1), 1);
  EXPECT_EQ(grid.cells(2), 6);
  EXPECT_EQ(grid.cell_count(), 60);
}

TEST(Grid, LinesAreSharedByNeighboursAndEndOnTheSides) {
  const Grid grid({3, {-0.1, 0.3, 0}, {0.7, 1.1, 0.1}}, {7, 3, 11});
  for (int axis = 0; axis < 3; ++axis) {
    EXPECT_EQ(grid.line(axis, 0), grid.box().low[axis]);
    EXPECT_EQ(grid.line(axis, grid.cells(axis)), grid.box().high[axis]);
    for (int i = 0; i + 1 < grid.cells(axis); ++i) {
      std::array<int, 3> left{}, right{};
      left[axis] = i;
      right[axis] = i + 1;
      EXPECT_EQ(grid.cell(left).high[axis], grid.cell(right).low[axis]);
      EXPECT_LT(grid.line(axis, i), grid.line(axis, i + 1));
    }
  }
}

TEST(Grid, NumbersAndPositionsAreInverse) {
  const Grid grid({3, {0, 0, 0}, {1, 1, 1}}, {4, 3, 5});
  for (int cell = 0; cell < grid.cell_count(); ++cell)
    EXPECT_EQ(grid.number(grid.position(cell)), cell);
  EXPECT_THAT(grid.position(1), testing::ElementsAre(1, 0, 0));
}

TEST(Grid, LocateFindsTheCellOfACoordinate) {
  std::mt19937 generator(1);
  const Grid grid({2, {-0.1, 0.3}, {0.7, 1e6}}, {13, 1000003, 1});
  for (int axis = 0; axis < 2; ++axis) {
    std::uniform_int_distribution<int> line(0, grid.cells(axis) - 1);
    for (int repeat = 0; repeat < 1000; ++repeat) {
      const int i = line(generator);
      const double at = grid.line(axis, i);
      EXPECT_EQ(grid.locate(axis, at), i);  // a line belongs to the cell on its right
      EXPECT_EQ(grid.locate(axis, std::nextafter(at, -1e9)), std::max(i - 1, 0));
      EXPECT_EQ(grid.locate(axis, 0.5 * (at + grid.line(axis, i + 1))), i);
    }
    EXPECT_EQ(grid.locate(axis, -1e9), 0);
    EXPECT_EQ(grid.locate(axis, 1e9), grid.cells(axis) - 1);
    EXPECT_EQ(grid.locate(axis, grid.box().high[axis]), grid.cells(axis) - 1);
  }
}

const std::vector<double> uneven[] = {{-1, 0, 0.25, 2}, {3, 3.9, 4}};

TEST(Grid, OfGivenLinesHasTheCellsBetweenThem) {
  const Grid grid = Grid::with_lines(uneven);
  EXPECT_FALSE(grid.is_uniform());
  EXPECT_EQ(grid.cell_count(), 6);
  EXPECT_EQ(grid.box().low[0], -1);
  EXPECT_EQ(grid.box().high[1], 4);
  double measure = 0;
  for (int cell = 0; cell < grid.cell_count(); ++cell) {
    const auto [i, j, k] = grid.position(cell);
    const Box box = grid.cell({i, j, k});
    EXPECT_EQ(box.low[0], uneven[0][i]);
    EXPECT_EQ(box.high[1], uneven[1][j + 1]);
    EXPECT_EQ(grid.width(0, i), uneven[0][i + 1] - uneven[0][i]);
    EXPECT_EQ(grid.cell_measure(cell), box.measure());
    measure += box.measure();
  }
  EXPECT_NEAR(measure, 3, 1e-15);
  EXPECT_EQ(grid.spacing(0), 1);  // the mean
  EXPECT_EQ(grid.smallest_width(0), 0.25);
  EXPECT_EQ(grid.largest_width(0), 1.75);
  EXPECT_NEAR(grid.largest_diagonal(), std::hypot(1.75, 0.9), 1e-15);
  EXPECT_NEAR(Grid(oblong, {3, 2, 1}).largest_diagonal(), std::hypot(1, 0.5), 1e-15);
}

TEST(Grid, OfGivenLinesLocatesAsAnyOther) {
  const Grid grid = Grid::with_lines(uneven);
  for (int i = 0; i < 3; ++i) {
    EXPECT_EQ(grid.locate(0, uneven[0][i]), i);
    EXPECT_EQ(grid.locate(0, std::nextafter(uneven[0][i], -9)), std::max(i - 1, 0));
  }
  EXPECT_EQ(grid.locate(0, -7), 0);
  EXPECT_EQ(grid.locate(0, 2), 2);
  EXPECT_EQ(grid.locate(0, 1e9), 2);
}

TEST(Grid, KnotsGoOnBeyondTheBoxWithTheOutermostWidths) {
  const Grid grid = Grid::with_lines(uneven), equal(oblong, {3, 2, 1});
  EXPECT_EQ(grid.knot(0, -2), -3);
  EXPECT_EQ(grid.knot(0, 1), 0);
  EXPECT_EQ(grid.knot(0, 5), 2 + 2 * 1.75);
  EXPECT_EQ(equal.knot(1, -1), 2.5);
  EXPECT_EQ(equal.knot(1, 3), 4.5);
}

TEST(Grid, EqualGridsAreThoseWithTheSameLines) {
  const std::vector<double> even[] = {{-1, 0, 1, 2}, {3, 3.5, 4}};
  const Grid grid = Grid::with_lines(uneven), equal(oblong, {3, 2, 1});
  EXPECT_EQ(grid, Grid::with_lines(uneven));
  EXPECT_EQ(equal, Grid::with_lines(even));
  EXPECT_FALSE(grid == equal);
  EXPECT_FALSE(equal == Grid(oblong, {3, 3, 1}));
  EXPECT_FALSE(equal == Grid({2, {-1, 3}, {2, 4.5}}, {3, 2, 1}));
}

TEST(Grid, LinesThatDoNotAscendAreRefused) {
  for (const std::vector<double>& bad :
       {std::vector<double>{0}, {0, 1, 1, 2}, {0, 2, 1}, {0, NAN, 1}, {0, 1, INFINITY}})
    EXPECT_THROW(Grid::with_lines(std::vector<std::vector<double>>{bad}), InvalidArgument);
  EXPECT_THROW(Grid::with_lines({}), InvalidArgument);
}

TEST(Grid, ImpossibleGridsAreRefused) {
  EXPECT_THROW(Grid(oblong, {0, 1, 1}), InvalidArgument);
  EXPECT_THROW(Grid(oblong, {2, -1, 1}), InvalidArgument);
  EXPECT_THROW(Grid({2, {0, 0}, {1, 0}}, {1, 1, 1}), InvalidArgument);
  EXPECT_THROW(Grid::with_square_cells(oblong, 0), InvalidArgument);
  EXPECT_THROW(Grid::with_square_cells(oblong, -3), InvalidArgument);
}

}  // namespace
}  // namespace rfm
