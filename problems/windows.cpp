#include "problems/windows.hpp"

#include <algorithm>
#include <cmath>

#include "core/bounding_box.hpp"
#include "core/error.hpp"
#include "core/r_functions.hpp"
#include "core/weight.hpp"
#include "problems/problem.hpp"

namespace rfm {
namespace {

constexpr int most_parts = 256;

Box box_of(const Region& region, const WindowOption& option) {
  try {
    return bounding_box(RegionEvaluator(region));
  } catch (const InvalidArgument&) {
    throw ProblemFileErrors({Mistake{"the window lies outside of the domain", option.place}});
  }
}

int parts_of_cell(const Grid& grid, const Box& box, const WindowOption& option) {
  double widest = 0;
  for (int axis = 0; axis < grid.dimension(); ++axis) {
    const int first = grid.locate(axis, box.low[axis]), last = grid.locate(axis, box.high[axis]);
    for (int cell = first; cell <= last; ++cell) widest = std::max(widest, grid.width(axis, cell));
  }
  const double wanted = box.longest_side() / option.cells;
  int parts = 1;
  while (widest / parts > wanted * (1 + 1e-9)) {
    parts *= 2;
    if (parts > most_parts)
      throw ProblemFileErrors(
          {Mistake{"cells of a window are at most 256 times smaller than those "
                   "of the domain: nest windows, or take more cells there",
                   option.place}});
  }
  return parts;
}

// The cells first … last − 1 along an axis that hold a box; one that is touched does not.
std::pair<int, int> covered(const Grid& grid, const Box& box, int axis) {
  int first = grid.locate(axis, box.low[axis]), last = grid.locate(axis, box.high[axis]) + 1;
  const auto touched = [&](double line, double side, int cell) {
    return std::fabs(line - side) < 1e-6 * grid.width(axis, cell);
  };
  if (first + 1 < last && touched(grid.line(axis, first + 1), box.low[axis], first)) ++first;
  if (first + 1 < last && touched(grid.line(axis, last - 1), box.high[axis], last - 1)) --last;
  return {first, last};
}

// The lines of cells first … last − 1, each divided. The same number wherever a line belongs to
// several grids, since parts are powers of two.
std::vector<double> divided(const Grid& grid, int axis, int first, int last, int parts) {
  std::vector<double> lines;
  for (int cell = first; cell < last; ++cell)
    for (int part = 0; part < parts; ++part)
      lines.push_back(part == 0 ? grid.line(axis, cell)
                                : grid.line(axis, cell) + grid.width(axis, cell) * part / parts);
  lines.push_back(grid.line(axis, last));
  return lines;
}

}  // namespace

std::vector<Window> windows(const Problem& problem, const Grid& grid, const Box& bounds,
                            int unknowns, int& function) {
  std::vector<Window> result;
  std::vector<WindowOption> options = structure_options(problem).windows;
  std::ranges::stable_partition(options, &WindowOption::global);
  for (const WindowOption& option : options) {
    const Box box = box_of(*problem.domain & option.region, option);
    // A product of two factors is positive again where both are negative: the R-function tells the
    // inside.
    const Field inside = apply(Operation::less, {0.0, implicit(option.region)});
    const Field omega =
        weight(RegionEvaluator(option.region), bounds).function / box.longest_side();
    result.push_back({option, box, select(inside, pow(omega, option.smoothness + 1), 0.0),
                      parts_of_cell(grid, box, option), function});
    function += unknowns;
  }
  return result;
}

Grid window_grid(const Window& window, const Grid& grid) {
  std::vector<std::vector<double>> lines;
  for (int axis = 0; axis < grid.dimension(); ++axis) {
    const auto [first, last] = covered(grid, window.box, axis);
    lines.push_back(divided(grid, axis, first, last, window.finer));
  }
  return Grid::with_lines(lines);
}

Grid common_grid(const Grid& grid, std::span<const Window> windows) {
  if (windows.empty()) return grid;
  std::vector<std::vector<double>> lines;
  for (int axis = 0; axis < grid.dimension(); ++axis)
    lines.push_back(divided(grid, axis, 0, grid.cells(axis), 1));
  for (const Window& window : windows) {
    const Grid own = window_grid(window, grid);
    for (int axis = 0; axis < grid.dimension(); ++axis)
      for (int i = 0; i <= own.cells(axis); ++i) lines[axis].push_back(own.line(axis, i));
  }
  for (std::vector<double>& axis : lines) {
    std::ranges::sort(axis);
    axis.erase(std::ranges::unique(axis).begin(), axis.end());
  }
  return Grid::with_lines(lines);
}

TensorProductSpace own_space(const Grid& own, const Grid& common, int degree,
                             std::span<const std::uint8_t> common_cells) {
  std::vector<std::uint8_t> cells(own.cell_count());
  for (int cell = 0; cell < common.cell_count(); ++cell) {
    if (common_cells[cell] == 0) continue;
    const Box box = common.cell(common.position(cell));
    std::array<int, 3> position{};
    bool is_in = true;
    for (int axis = 0; axis < common.dimension(); ++axis) {
      const double middle = 0.5 * (box.low[axis] + box.high[axis]);
      is_in = is_in && middle > own.box().low[axis] && middle < own.box().high[axis];
      position[axis] = own.locate(axis, middle);
    }
    if (is_in) cells[own.number(position)] = 1;
  }
  return TensorProductSpace(own, degree, cells);
}

}  // namespace rfm
