#include "solvers/cell_tiles.hpp"

#include <algorithm>

namespace rfm {

CellTiles::CellTiles(const Grid& grid, int degree) : grid_(grid) {
  // Wide enough to amortise a task, narrow enough that small grids occupy all threads.
  constexpr std::array<int, 3> wide{128, 16, 8};
  for (int axis = 0; axis < grid.dimension(); ++axis) {
    width_[axis] = std::max(degree + 1, wide[grid.dimension() - 1]);
    counts_[axis] = (grid.cells(axis) + width_[axis] - 1) / width_[axis];
  }
  colours_.resize(8);
  for (int tile = 0; tile < count(); ++tile) {
    const int x = tile % counts_[0], y = tile / counts_[0] % counts_[1];
    const int z = tile / (counts_[0] * counts_[1]);
    colours_[x % 2 + 2 * (y % 2) + 4 * (z % 2)].push_back(tile);
  }
  std::erase_if(colours_, [](const std::vector<int>& tiles) { return tiles.empty(); });
}

}  // namespace rfm
