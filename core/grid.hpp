#pragma once

#include <array>
#include <memory>
#include <span>
#include <vector>

#include "core/box.hpp"

namespace rfm {

/// The background grid: a box divided into cells along each axis, equal ones or, with `with_lines`,
/// of any widths. It knows nothing of the shape. Cells are numbered with x running fastest.
class Grid {
 public:
  /// `cells[axis]` ≥ 1 cells along each of the box's axes. Throws `InvalidArgument` otherwise.
  Grid(const Box& box, std::array<int, 3> cells);

  /// The rule of problem files: `cells_along_longest` cells of side h along the longest side, and
  /// ceil(side / h) along the others, the grid centred on `box` (so it may exceed the shorter
  /// sides). Throws `InvalidArgument` as above.
  static Grid with_square_cells(const Box& box, int cells_along_longest);

  /// Cells between the given lines of each axis, at least two and ascending. Throws
  /// `InvalidArgument` otherwise.
  static Grid with_lines(std::span<const std::vector<double>> lines);

  int dimension() const { return box_.dimension; }
  const Box& box() const { return box_; }
  int cells(int axis) const { return cells_[axis]; }
  int cell_count() const;
  /// Whether all cells are equal.
  bool is_uniform() const { return lines_ == nullptr; }
  /// The side of a cell along an axis, of cells that are not equal their mean.
  double spacing(int axis) const { return spacing_[axis]; }
  /// The side of the cells between grid lines `index` and `index` + 1.
  double width(int axis, int index) const {
    return is_uniform() ? spacing_[axis] : line(axis, index + 1) - line(axis, index);
  }
  double smallest_width(int axis) const;
  double largest_width(int axis) const;
  /// The diagonal of cells of the largest widths.
  double largest_diagonal() const;
  /// Length, area or volume of a cell.
  double cell_measure(int cell) const;
  /// Grid line `index` of `axis`, 0 … cells(axis); neighbours share the identical number, and the
  /// first and last are exactly the sides of the box.
  double line(int axis, int index) const {
    if (!is_uniform()) return (*lines_)[axis][index];
    return index == cells_[axis] ? box_.high[axis] : box_.low[axis] + index * spacing_[axis];
  }
  /// The same, continued beyond the box with the widths of the first and last cells: the knots of
  /// splines.
  double knot(int axis, int index) const;
  std::array<int, 3> position(int cell) const;
  int number(const std::array<int, 3>& position) const;
  Box cell(const std::array<int, 3>& position) const;
  /// Index of the cell of `axis` that holds `coordinate`, clamped to the grid.
  int locate(int axis, double coordinate) const;
  /// The same box and lines.
  friend bool operator==(const Grid& a, const Grid& b);

 private:
  Box box_;
  std::array<int, 3> cells_;
  std::array<double, 3> spacing_{};
  std::shared_ptr<const std::array<std::vector<double>, 3>> lines_;  // where cells are not equal
};

}  // namespace rfm
