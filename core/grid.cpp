#include "core/grid.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "core/error.hpp"

namespace rfm {

Grid::Grid(const Box& box, std::array<int, 3> cells) : box_(box), cells_(cells) {
  for (int axis = 0; axis < 3; ++axis) {
    if (axis >= box_.dimension) {
      cells_[axis] = 1;
      continue;
    }
    if (cells_[axis] < 1)
      throw InvalidArgument("a grid needs at least one cell along each axis, got " +
                            std::to_string(cells_[axis]));
    if (!(box_.length(axis) > 0))
      throw InvalidArgument("the box of a grid must have positive sides");
    spacing_[axis] = box_.length(axis) / cells_[axis];
  }
}

Grid Grid::with_square_cells(const Box& box, int cells_along_longest) {
  if (cells_along_longest < 1)
    throw InvalidArgument("a grid needs at least one cell along each axis, got " +
                          std::to_string(cells_along_longest));
  const double side = box.longest_side() / cells_along_longest;
  // A side that is a whole number of cells up to rounding must not get one cell more.
  constexpr double rounding = 1e-9;
  Box grid_box = box;
  std::array<int, 3> cells{1, 1, 1};
  for (int axis = 0; axis < box.dimension; ++axis) {
    const double ratio = box.length(axis) / side;
    cells[axis] = std::max(1, static_cast<int>(std::ceil(ratio - rounding)));
    const double excess = cells[axis] * side - box.length(axis);
    if (excess > rounding * side) {
      grid_box.low[axis] -= 0.5 * excess;
      grid_box.high[axis] += 0.5 * excess;
    }
  }
  return Grid(grid_box, cells);
}

int Grid::cell_count() const { return cells_[0] * cells_[1] * cells_[2]; }

std::array<int, 3> Grid::position(int cell) const {
  return {cell % cells_[0], cell / cells_[0] % cells_[1], cell / (cells_[0] * cells_[1])};
}

int Grid::number(const std::array<int, 3>& position) const {
  return position[0] + cells_[0] * (position[1] + cells_[1] * position[2]);
}

Box Grid::cell(const std::array<int, 3>& position) const {
  Box cell;
  cell.dimension = box_.dimension;
  for (int axis = 0; axis < box_.dimension; ++axis) {
    cell.low[axis] = line(axis, position[axis]);
    cell.high[axis] = line(axis, position[axis] + 1);
  }
  return cell;
}

int Grid::locate(int axis, double coordinate) const {
  const double offset = (coordinate - box_.low[axis]) / spacing_[axis];
  int index = static_cast<int>(std::floor(std::clamp(offset, 0.0, double(cells_[axis] - 1))));
  if (index > 0 && coordinate < line(axis, index)) --index;
  if (index + 1 < cells_[axis] && coordinate >= line(axis, index + 1)) ++index;
  return index;
}

}  // namespace rfm
