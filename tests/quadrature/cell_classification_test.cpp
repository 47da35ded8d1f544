#include "quadrature/cell_classification.hpp"

#include <gmock/gmock.h>

#include "tests/quadrature/regions.hpp"

using namespace rfm;
using namespace rfm::test;

namespace {

TEST(CellClassification, InsideAndOutsideAreProved) {
  // Against membership of many points of each cell, on grids that are no powers of two.
  const Region region = (disk(0, 0, 1) - disk(0.6, 0.3, 0.7)) | star(0.2, 0.3);
  const RegionEvaluator evaluator(region);
  Box box;
  box.low = {-1.3, -1.1, 0};
  box.high = {1.2, 1.4, 0};
  const Grid cells(box, {13, 7, 1});
  const CellClassification classification = classify_cells(evaluator, cells);
  int decided = 0;
  for (int cell = 0; cell < cells.cell_count(); ++cell) {
    const Box b = cells.cell(cells.position(cell));
    if (classification.states[cell] == CellState::cut) continue;
    ++decided;
    for (int i = 0; i <= 8; ++i)
      for (int j = 0; j <= 8; ++j) {
        const Point p{b.low[0] + b.length(0) * i / 8, b.low[1] + b.length(1) * j / 8, 0};
        EXPECT_EQ(evaluator.contains(p), classification.states[cell] == CellState::inside);
      }
  }
  EXPECT_GT(decided, 30);
}

TEST(CellClassification, OfAnExpressionWithManyBranchesIsThatOfItsBoundsAsAWhole) {
  // A union of 60 circles within one expression, and one of functions of which none can be left
  // out.
  const Field x = x_coordinate(), y = y_coordinate();
  Field circles = -1.0, alike = -1.0;
  for (int k = 0; k < 60; ++k) {
    const double a = std::sin(17.0 * k), b = std::sin(29.0 * k + 1);
    circles = max(circles, 0.02 - pow(x - a, 2) - pow(y - b, 2));
    alike = max(alike, 0.5 - x * x - y * y + 1e-3 * sin(k * x + y));
  }
  for (const Field& field : {circles, alike}) {
    const RegionEvaluator region(Region(Primitive{"", field, field}, 2));
    const Grid cells = grid(1.3, 37);
    const auto loose = classify_cells(region, cells, {}, Classification::loose);
    int inside = 0;
    for (int cell = 0; cell < cells.cell_count(); ++cell) {
      const Interval range =
          region.level(0).value_bounds(quadrature_cell(cells, cells.position(cell)));
      const CellState expected = range.low >= 0   ? CellState::inside
                                 : range.high < 0 ? CellState::outside
                                                  : CellState::cut;
      EXPECT_EQ(loose.states[cell], expected);
      inside += expected == CellState::inside;
    }
    EXPECT_GT(inside, 20);
    const auto tight = classify_cells(region, cells);
    EXPECT_LE(tight.cut_cells.size(), loose.cut_cells.size());
  }
}

TEST(CellClassification, CutCellsOfADiskAreThoseItsCircleMeets) {
  // Bounds of a quadric are sharp: no other cell is undecided.
  const Region region = disk(0.1, -0.07, 1);
  const Grid cells = grid(1.7, 23);
  const CellClassification classification = classify_cells(RegionEvaluator(region), cells);
  int cut = 0;
  for (int cell = 0; cell < cells.cell_count(); ++cell) {
    const Box b = cells.cell(cells.position(cell));
    const auto nearest = [](double c, double low, double high) {
      return std::max({low - c, c - high, 0.0});
    };
    const auto farthest = [](double c, double low, double high) {
      return std::max(high - c, c - low);
    };
    const double near =
        std::hypot(nearest(0.1, b.low[0], b.high[0]), nearest(-0.07, b.low[1], b.high[1]));
    const double far =
        std::hypot(farthest(0.1, b.low[0], b.high[0]), farthest(-0.07, b.low[1], b.high[1]));
    const CellState expected = far < 1    ? CellState::inside
                               : near > 1 ? CellState::outside
                                          : CellState::cut;
    EXPECT_EQ(classification.states[cell], expected) << "cell " << cell;
    cut += expected == CellState::cut;
  }
  EXPECT_EQ(classification.cut_cells.size(), static_cast<std::size_t>(cut));
  EXPECT_TRUE(std::ranges::is_sorted(classification.cut_cells));
}

TEST(CellClassification, CellsKeepOnlyThePrimitivesThatMatterThere) {
  const RegionEvaluator evaluator(disk(0, 0, 1) - disk(3, 0, 1.5));
  Box box;
  box.low = {-2, -2, 0};
  box.high = {5, 2, 0};
  const CellClassification classification = classify_cells(evaluator, Grid(box, {70, 40, 1}));
  for (std::size_t i = 0; i < classification.cut_cells.size(); ++i) {
    // The disks do not meet: the second does not matter anywhere.
    ASSERT_EQ(classification.primitives(static_cast<int>(i)).size(), 1u);
    EXPECT_EQ(classification.primitives(static_cast<int>(i))[0], 0);
    EXPECT_TRUE(classification.table(static_cast<int>(i)).value(1));
  }
}

TEST(CellClassification, PrimitivesHiddenByAbsorptionCutNothing) {
  // a | (a & b): the tree cannot see that b does not matter where a is undecided, the table can.
  const Region a = disk(0, 0, 1), b = half_plane(1, 0.3, 0);
  const CellClassification classification =
      classify_cells(RegionEvaluator(a | (a & b)), grid(1.3, 10));
  for (std::size_t i = 0; i < classification.cut_cells.size(); ++i)
    EXPECT_EQ(classification.primitives(static_cast<int>(i)).size(), 1u);
}

TEST(CellClassification, CellsInsideCrossedByAnInterfaceAreCut) {
  std::vector<LevelFunction> interfaces;
  interfaces.emplace_back(x() - 0.01, 2);
  const CellClassification classification =
      classify_cells(RegionEvaluator(disk(0, 0, 2)), grid(1, 5), interfaces);
  EXPECT_EQ(classification.cut_cells, (std::vector{2, 7, 12, 17, 22}));
  for (int i = 0; i < 5; ++i) {
    EXPECT_TRUE(classification.primitives(i).empty());
    EXPECT_EQ(classification.interfaces(i).size(), 1u);
  }
}

}  // namespace
