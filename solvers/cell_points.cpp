#include "solvers/cell_points.hpp"

#include <algorithm>

namespace rfm {
namespace {

std::vector<PointRange> ranges_by_cell(const SurfaceRule& surface, int cells) {
  std::vector<PointRange> ranges;
  if (!surface.cells.empty()) ranges.resize(cells);
  for (std::size_t i = 0; i < surface.cells.size(); ++i)
    ranges[surface.cells[i]] = surface.range(static_cast<int>(i));
  return ranges;
}

}  // namespace

CellPointIndex::CellPointIndex(const DomainRule& rule)
    : rule_(rule),
      inside_rule_(rule.inside_rule()),
      cut_(rule.grid().cell_count()),
      boundary_(ranges_by_cell(rule.boundary(), rule.grid().cell_count())),
      interfaces_(ranges_by_cell(rule.interfaces(), rule.grid().cell_count())) {
  for (std::size_t i = 0; i < rule.cut_cells().size(); ++i)
    cut_[rule.cut_cells()[i]] = rule.cut_range(static_cast<int>(i));
}

void CellPointIndex::add_inside(int cell, IntegrandPoints& points) const {
  const Grid& grid = rule_.grid();
  const GaussRule& rule = inside_rule_;
  const std::array<int, 3> position = grid.position(cell);
  const int dimension = grid.dimension(), size = rule.size();
  std::array<double, 3> low{}, side{};
  double measure = 1;
  for (int axis = 0; axis < dimension; ++axis) {
    low[axis] = grid.line(axis, position[axis]);
    side[axis] = grid.width(axis, position[axis]);
    measure *= side[axis];
  }
  for (int k = 0; k < (dimension > 2 ? size : 1); ++k)
    for (int j = 0; j < (dimension > 1 ? size : 1); ++j) {
      const double factor =
          measure * (dimension > 1 ? rule.weights[j] : 1) * (dimension > 2 ? rule.weights[k] : 1);
      for (int i = 0; i < size; ++i) {
        points.coordinates[0].push_back(low[0] + rule.nodes[i] * side[0]);
        if (dimension > 1) points.coordinates[1].push_back(low[1] + rule.nodes[j] * side[1]);
        if (dimension > 2) points.coordinates[2].push_back(low[2] + rule.nodes[k] * side[2]);
        points.weights.push_back(factor * rule.weights[i]);
      }
    }
}

void CellPointIndex::add_cut(PointRange range, IntegrandPoints& points) const {
  const VolumePoints& from = rule_.cut_points();
  const auto append = [&](std::vector<double>& to, const std::vector<double>& values) {
    to.insert(to.end(), values.begin() + range.begin, values.begin() + range.end);
  };
  for (int axis = 0; axis < rule_.dimension(); ++axis)
    append(points.coordinates[axis], from.coordinates[axis]);
  append(points.weights, from.weights);
}

void CellPointIndex::add_surface(Contribution::Place place, PointRange range,
                                 std::span<const int> numbers, IntegrandPoints& points) const {
  const SurfacePoints& from =
      place == Contribution::Place::boundary ? rule_.boundary().points : rule_.interfaces().points;
  for (int i = range.begin; i < range.end; ++i) {
    if (!numbers.empty() &&
        std::find(numbers.begin(), numbers.end(), from.numbers[i]) == numbers.end())
      continue;
    for (int axis = 0; axis < 3; ++axis) {
      if (axis < rule_.dimension()) points.coordinates[axis].push_back(from.coordinates[axis][i]);
      points.normals[axis].push_back(axis < rule_.dimension() ? from.normals[axis][i] : 0.0);
    }
    points.weights.push_back(from.weights[i]);
  }
}

}  // namespace rfm
