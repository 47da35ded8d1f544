#include "solvers/cell_tiles.hpp"

#include <gmock/gmock.h>

#include <map>

#include "basis/tensor_product_space.hpp"

namespace rfm {
namespace {

class EveryGrid : public testing::TestWithParam<std::tuple<int, int>> {};
INSTANTIATE_TEST_SUITE_P(CellTiles, EveryGrid,
                         testing::Combine(testing::Values(1, 2, 3), testing::Values(1, 3, 8)));

Grid grid_of(int dimension) {
  const std::array<int, 3> cells = dimension == 1   ? std::array{700, 1, 1}
                                   : dimension == 2 ? std::array{67, 50, 1}
                                                    : std::array{35, 19, 26};
  return Grid({dimension, {0, 0, 0}, {1, 1, 1}}, cells);
}

TEST_P(EveryGrid, HoldTogetherEveryCellOnce) {
  const auto [dimension, degree] = GetParam();
  const Grid grid = grid_of(dimension);
  const CellTiles tiles(grid, degree);
  std::vector<int> visits(grid.cell_count(), 0);
  int tile_count = 0;
  for (const std::vector<int>& colour : tiles.colours())
    for (const int tile : colour) {
      ++tile_count;
      tiles.visit_cells(tile, [&](int cell) { ++visits[cell]; });
    }
  EXPECT_EQ(tile_count, tiles.count());
  EXPECT_GT(tile_count, 1);
  EXPECT_THAT(visits, testing::Each(1));
}

TEST_P(EveryGrid, TilesOfOneColourShareNoSpline) {
  const auto [dimension, degree] = GetParam();
  const Grid grid = grid_of(dimension);
  const CellTiles tiles(grid, degree);
  const TensorProductSpace space(grid, degree);
  std::vector<int> functions(space.functions_per_cell());
  for (const std::vector<int>& colour : tiles.colours()) {
    std::map<int, int> owner;
    for (const int tile : colour)
      tiles.visit_cells(tile, [&, degree = degree, dimension = dimension](int cell) {
        // Corners suffice: the splines of a cell are a box of places.
        space.cell_functions(cell, functions);
        const int last = static_cast<int>(functions.size()) - 1;
        for (const int corner : {0, degree, last - degree, last})
          ASSERT_EQ(owner.emplace(functions[corner], tile).first->second, tile);
      });
  }
}

}  // namespace
}  // namespace rfm
