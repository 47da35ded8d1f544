#pragma once

#include <array>

#include "core/box.hpp"

namespace rfm {

/// The background grid: a box divided into equal cells along each axis. It knows nothing of the
/// shape. Cells are numbered with x running fastest.
class Grid {
 public:
  /// `cells[axis]` ≥ 1 cells along each of the box's axes. Throws `InvalidArgument` otherwise.
  Grid(const Box& box, std::array<int, 3> cells);

  /// The rule of problem files: `cells_along_longest` cells of side h along the longest side, and
  /// ceil(side / h) along the others, the grid centred on `box` (so it may exceed the shorter
  /// sides). Throws `InvalidArgument` as above.
  static Grid with_square_cells(const Box& box, int cells_along_longest);

  int dimension() const { return box_.dimension; }
  const Box& box() const { return box_; }
  int cells(int axis) const { return cells_[axis]; }
  int cell_count() const;
  double spacing(int axis) const { return spacing_[axis]; }
  /// Grid line `index` of `axis`, 0 … cells(axis); neighbours share the identical number, and the
  /// first and last are exactly the sides of the box.
  double line(int axis, int index) const {
    return index == cells_[axis] ? box_.high[axis] : box_.low[axis] + index * spacing_[axis];
  }
  std::array<int, 3> position(int cell) const;
  int number(const std::array<int, 3>& position) const;
  Box cell(const std::array<int, 3>& position) const;
  /// Index of the cell of `axis` that holds `coordinate`, clamped to the grid.
  int locate(int axis, double coordinate) const;

 private:
  Box box_;
  std::array<int, 3> cells_;
  std::array<double, 3> spacing_{};
};

}  // namespace rfm
