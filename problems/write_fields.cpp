#include "problems/write_fields.hpp"

#include <algorithm>

#include "problems/output/vtu_file.hpp"

namespace rfm {

void write_vtu(const DiscretizedRegion& domain, const std::vector<NamedField>& fields,
               const std::string& path, int resolution) {
  const Grid& grid = domain.grid();
  int most_cells = 1;
  for (int axis = 0; axis < grid.dimension(); ++axis)
    most_cells = std::max(most_cells, grid.cells(axis));
  TessellationOptions options;
  options.subdivisions = std::max(1, (resolution + most_cells - 1) / most_cells);
  write_vtu(sample(tessellate(domain.evaluator(), grid, options), fields, grid.dimension()), path);
}

}  // namespace rfm
