#pragma once

#include <array>
#include <functional>
#include <vector>

#include "core/grid.hpp"

namespace rfm {

/// Blocks of neighbouring cells, coloured like a chess board (2^dimension colours), so that tiles
/// of one colour can be worked on at the same time: they are a tile apart, and tiles are at least
/// as wide as splines of the given degree reach, so that no spline is touched by two of them. Sums
/// into shared arrays therefore come out the same, bit by bit, for any number of threads.
class CellTiles {
 public:
  CellTiles(const Grid& grid, int degree);

  int count() const { return counts_[0] * counts_[1] * counts_[2]; }
  /// Tiles of one colour; colours are worked on one after the other.
  const std::vector<std::vector<int>>& colours() const { return colours_; }
  /// Calls visit(cell) for the cells of a tile, in the order of their numbers.
  template <class Visit>
  void visit_cells(int tile, Visit&& visit) const {
    std::array<int, 3> begin{}, end{1, 1, 1};
    for (int axis = 0, rest = tile; axis < 3; ++axis) {
      begin[axis] = rest % counts_[axis] * width_[axis];
      end[axis] = std::min(begin[axis] + width_[axis], grid_.cells(axis));
      rest /= counts_[axis];
    }
    for (int k = begin[2]; k < end[2]; ++k)
      for (int j = begin[1]; j < end[1]; ++j)
        for (int i = begin[0]; i < end[0]; ++i) visit(grid_.number({i, j, k}));
  }

 private:
  Grid grid_;
  std::array<int, 3> width_{1, 1, 1}, counts_{1, 1, 1};
  std::vector<std::vector<int>> colours_;
};

}  // namespace rfm
