#include "quadrature/rule_parts.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace rfm {
namespace {

template <class Points>
void move_into(const Box& box, Points& points) {
  for (int axis = 0; axis < box.dimension; ++axis)
    for (double& x : points.coordinates[axis]) x = std::clamp(x, box.low[axis], box.high[axis]);
}

// The cell to which a surface point found in `cell` belongs. On a side of the cell with the inside
// beyond it, that is the neighbour.
int inner_cell(const Grid& grid, const std::vector<CellState>& states, int cell, const Point& point,
               const Point& normal) {
  std::array<int, 3> position = grid.position(cell);
  for (int axis = 0; axis < grid.dimension(); ++axis) {
    const double same = 1e-12 * grid.width(axis, position[axis]);
    const int low = position[axis];
    if (normal[axis] > 0 && low > 0 && std::fabs(point[axis] - grid.line(axis, low)) <= same)
      --position[axis];
    else if (normal[axis] < 0 && low + 1 < grid.cells(axis) &&
             std::fabs(point[axis] - grid.line(axis, low + 1)) <= same)
      ++position[axis];
  }
  const int inner = grid.number(position);
  return states[inner] == CellState::outside ? cell : inner;
}

// The owners of the points of each part, one part after the other.
std::vector<int> owners_of(const Grid& grid, const std::vector<CellState>& states,
                           std::span<const RulePart> parts, SurfacePoints RulePart::*points,
                           int CellContribution::*count) {
  std::vector<std::size_t> begin{0};
  for (const RulePart& part : parts) begin.push_back(begin.back() + (part.*points).weights.size());
  std::vector<int> owners(begin.back());
  tbb::parallel_for(std::size_t{0}, parts.size(), [&](std::size_t p) {
    const SurfacePoints& own = parts[p].*points;
    int i = 0;
    for (const CellContribution& cell : parts[p].cells)
      for (const int end = i + cell.*count; i < end; ++i)
        owners[begin[p] + static_cast<std::size_t>(i)] =
            inner_cell(grid, states, cell.report.cell, own.point(i), own.normal(i));
  });
  return owners;
}

// One array of all parts, in their order or in `order` if that is not empty.
template <class Value, class Array>
std::vector<Value> joined(std::span<RulePart> parts, std::size_t size,
                          const std::vector<int>& order, Array&& array) {
  std::vector<Value> all;
  all.reserve(size);
  for (RulePart& part : parts) {
    const std::vector<Value> own = std::move(array(part));
    all.insert(all.end(), own.begin(), own.end());
  }
  if (order.empty()) return all;
  std::vector<Value> sorted(all.size());
  for (std::size_t i = 0; i < all.size(); ++i) sorted[i] = all[order[i]];
  return sorted;
}

}  // namespace

void RulePart::take(const Box& grid_box, const CellRule& rule) {
  volume = rule.volume;
  boundary = rule.boundary;
  interfaces = rule.interfaces;
  move_into(grid_box, volume);
  move_into(grid_box, boundary);
  move_into(grid_box, interfaces);
  const Point center = grid_box.center();
  for (int axis = 0; axis < grid_box.dimension; ++axis)
    for (int i = 0; i < boundary.size(); ++i)
      flux.add(boundary.weights[i] * boundary.normals[axis][i] *
               (boundary.coordinates[axis][i] - center[axis]));
}

VolumePoints joined_volume(int dimension, std::span<RulePart> parts) {
  std::size_t size = 0;
  for (const RulePart& part : parts) size += part.volume.weights.size();
  VolumePoints all;
  tbb::parallel_for(0, dimension + 1, [&](int i) {
    const auto array = [&](VolumePoints& points) -> std::vector<double>& {
      return i < dimension ? points.coordinates[i] : points.weights;
    };
    array(all) = joined<double>(parts, size, {}, [&](RulePart& part) -> std::vector<double>& {
      return array(part.volume);
    });
  });
  return all;
}

SurfaceRule joined_surface(const Grid& grid, const std::vector<CellState>& states,
                           std::span<RulePart> parts, SurfacePoints RulePart::*points,
                           int CellContribution::*count) {
  const std::vector<int> owners = owners_of(grid, states, parts, points, count);
  std::vector<int> order;
  if (!std::ranges::is_sorted(owners)) {
    order.resize(owners.size());
    std::iota(order.begin(), order.end(), 0);
    std::ranges::stable_sort(order, {}, [&](int i) { return owners[i]; });
  }
  SurfaceRule rule;
  for (int i = 0; i < static_cast<int>(owners.size()); ++i) {
    const int owner = owners[order.empty() ? i : order[i]];
    if (rule.cells.empty() || rule.cells.back() != owner) {
      rule.cells.push_back(owner);
      rule.begin.push_back(i);
    }
    rule.begin.back() = i + 1;
  }
  const int dimension = grid.dimension();
  tbb::parallel_for(0, 2 * dimension + 2, [&](int i) {
    if (i == 2 * dimension + 1) {
      rule.points.numbers =
          joined<int>(parts, owners.size(), order,
                      [&](RulePart& part) -> std::vector<int>& { return (part.*points).numbers; });
      return;
    }
    const auto array = [&](SurfacePoints& all) -> std::vector<double>& {
      return i < dimension       ? all.coordinates[i]
             : i < 2 * dimension ? all.normals[i - dimension]
                                 : all.weights;
    };
    array(rule.points) =
        joined<double>(parts, owners.size(), order,
                       [&](RulePart& part) -> std::vector<double>& { return array(part.*points); });
  });
  return rule;
}

}  // namespace rfm
