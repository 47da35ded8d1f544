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

Grid Grid::with_lines(std::span<const std::vector<double>> lines) {
  if (lines.empty() || lines.size() > 3)
    throw InvalidArgument("a grid has one to three axes, got lines for " +
                          std::to_string(lines.size()));
  Box box;
  box.dimension = static_cast<int>(lines.size());
  std::array<int, 3> cells{1, 1, 1};
  std::array<std::vector<double>, 3> own;
  for (int axis = 0; axis < box.dimension; ++axis) {
    own[axis] = lines[axis];
    if (own[axis].size() < 2) throw InvalidArgument("a grid needs two lines along each axis");
    for (std::size_t i = 0; i + 1 < own[axis].size(); ++i)
      if (!(own[axis][i] < own[axis][i + 1]) || !std::isfinite(own[axis][i + 1] - own[axis][i]))
        throw InvalidArgument("the lines of a grid must be finite and ascend");
    box.low[axis] = own[axis].front();
    box.high[axis] = own[axis].back();
    cells[axis] = static_cast<int>(own[axis].size()) - 1;
  }
  Grid grid(box, cells);
  grid.lines_ = std::make_shared<const std::array<std::vector<double>, 3>>(std::move(own));
  return grid;
}

double Grid::smallest_width(int axis) const {
  double least = spacing_[axis];
  for (int i = 0; !is_uniform() && i < cells_[axis]; ++i) least = std::min(least, width(axis, i));
  return least;
}

double Grid::largest_width(int axis) const {
  double largest = spacing_[axis];
  for (int i = 0; !is_uniform() && i < cells_[axis]; ++i)
    largest = std::max(largest, width(axis, i));
  return largest;
}

double Grid::largest_diagonal() const {
  double diagonal = 0;
  for (int axis = 0; axis < dimension(); ++axis)
    diagonal = std::hypot(diagonal, largest_width(axis));
  return diagonal;
}

double Grid::cell_measure(int cell) const {
  const std::array<int, 3> at = position(cell);
  double measure = 1;
  for (int axis = 0; axis < dimension(); ++axis) measure *= width(axis, at[axis]);
  return measure;
}

double Grid::knot(int axis, int index) const {
  const int last = cells_[axis];
  if (index < 0) return box_.low[axis] + index * width(axis, 0);
  if (index > last) return box_.high[axis] + (index - last) * width(axis, last - 1);
  return line(axis, index);
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
  if (!is_uniform()) {
    const std::vector<double>& lines = (*lines_)[axis];
    const auto above = std::upper_bound(lines.begin(), lines.end(), coordinate) - lines.begin();
    return static_cast<int>(std::clamp<std::ptrdiff_t>(above - 1, 0, cells_[axis] - 1));
  }
  const double offset = (coordinate - box_.low[axis]) / spacing_[axis];
  int index = static_cast<int>(std::floor(std::clamp(offset, 0.0, double(cells_[axis] - 1))));
  if (index > 0 && coordinate < line(axis, index)) --index;
  if (index + 1 < cells_[axis] && coordinate >= line(axis, index + 1)) ++index;
  return index;
}

bool operator==(const Grid& a, const Grid& b) {
  if (a.dimension() != b.dimension() || a.cells_ != b.cells_ || a.box_.low != b.box_.low ||
      a.box_.high != b.box_.high)
    return false;
  for (int axis = 0; axis < a.dimension(); ++axis)
    for (int i = 0; a.lines_ != b.lines_ && i < a.cells_[axis]; ++i)
      if (a.line(axis, i) != b.line(axis, i)) return false;
  return true;
}

}  // namespace rfm
