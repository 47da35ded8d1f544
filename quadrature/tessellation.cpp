#include "quadrature/tessellation.hpp"

#include <tbb/parallel_for.h>

#include "core/error.hpp"
#include "quadrature/tessellator.hpp"

namespace rfm {
namespace {

void append(Tessellation& all, const Tessellation& part) {
  const int first_vertex = static_cast<int>(all.vertices.size());
  all.vertices.insert(all.vertices.end(), part.vertices.begin(), part.vertices.end());
  all.elements.append(part.elements, first_vertex);
  all.boundary.append(part.boundary, first_vertex);
  all.grid_cells.insert(all.grid_cells.end(), part.grid_cells.begin(), part.grid_cells.end());
  all.primitives.insert(all.primitives.end(), part.primitives.begin(), part.primitives.end());
  all.uncertified += part.uncertified;
}

}  // namespace

void ElementList::add(ElementShape shape, std::span<const int> vertices) {
  connectivity.insert(connectivity.end(), vertices.begin(), vertices.end());
  begin.push_back(static_cast<int>(connectivity.size()));
  shapes.push_back(shape);
}

void ElementList::append(const ElementList& other, int first_vertex) {
  const int offset = static_cast<int>(connectivity.size());
  for (const int vertex : other.connectivity) connectivity.push_back(first_vertex + vertex);
  for (int e = 0; e < other.size(); ++e) begin.push_back(offset + other.begin[e + 1]);
  shapes.insert(shapes.end(), other.shapes.begin(), other.shapes.end());
}

Tessellation tessellate(const RegionEvaluator& region, const Grid& grid,
                        const TessellationOptions& options,
                        std::span<const LevelFunction> interfaces) {
  if (options.subdivisions < 1)
    throw InvalidArgument("a tessellation needs at least one subdivision per cell");
  const CellClassification classification = classify_cells(region, grid, interfaces);
  const CellSurfaces surfaces(region, interfaces);
  const Breakpoints breakpoints = surfaces.breakpoints(options.breakpoints);
  std::vector<int> cut_number(grid.cell_count(), -1);
  for (std::size_t i = 0; i < classification.cut_cells.size(); ++i)
    cut_number[classification.cut_cells[i]] = static_cast<int>(i);

  constexpr int part_size = 64;
  std::vector<Tessellation> parts((grid.cell_count() + part_size - 1) / part_size);
  tbb::parallel_for(std::size_t{0}, parts.size(), [&](std::size_t p) {
    Tessellation& part = parts[p];
    Subdivision subdivision(options.subdivision);
    const int first = static_cast<int>(p) * part_size;
    for (int cell = first; cell < std::min(first + part_size, grid.cell_count()); ++cell) {
      const auto position = grid.position(cell);
      Point spacing{};
      for (int axis = 0; axis < grid.dimension(); ++axis)
        spacing[axis] = grid.width(axis, position[axis]) / options.subdivisions;
      Tessellator tessellator(grid.box(), spacing, part);
      const auto visit = [&](const Box& box, const ActiveSet& active) {
        part.uncertified += subdivision.run(box, active, tessellator);
      };
      if (cut_number[cell] >= 0)
        part.uncertified += surfaces.visit_cut_cell(
            classification, cut_number[cell], quadrature_cell(grid, position), breakpoints, visit);
      else if (classification.states[cell] == CellState::inside)
        surfaces.visit_inside_cell(grid.cell(position), breakpoints, visit);
      part.grid_cells.resize(part.elements.size(), cell);
    }
  });
  Tessellation all;
  for (const Tessellation& part : parts) append(all, part);
  return all;
}

}  // namespace rfm
