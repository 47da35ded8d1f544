#include "problems/result_meshes.hpp"

#include <algorithm>

#include "core/r_functions.hpp"
#include "problems/field_sampling.hpp"
#include "problems/result_scope.hpp"
#include "quadrature/boundary_surface.hpp"

namespace rfm {
namespace {

std::vector<NamedField> output_fields(const ScalarProblem& problem,
                                      const ScalarSolution& solution) {
  const Problem& file = problem.problem();
  ExpressionScope scope = file.scope;
  define_results(scope, solution.results);
  std::vector<std::string> names = file.physics.unknowns;
  if (names.size() == 1) names.emplace_back("gradient");
  for (std::size_t i = 0; i < solution.results.modes.size(); ++i)
    for (const std::string& part : mode_parts(solution.results, i)) names.push_back(part);
  for (const std::string& name : file.outputs.fields)
    if (std::ranges::find(names, name) == names.end()) names.push_back(name);
  std::vector<NamedField> fields;
  for (const std::string& name : names)
    fields.push_back({name, evaluate(Expression(name), scope).components});
  fields.push_back({"omega", {implicit(problem.region().region())}});
  return fields;
}

FieldMesh boundary_mesh(const BoundarySurface& surface, std::vector<NamedField> fields,
                        const std::vector<Field>& flux, const Box& bounds) {
  FieldMesh mesh;
  mesh.points = surface.points;
  mesh.corners = surface.facets.connectivity;
  mesh.cell_begin = surface.facets.begin;
  for (const ElementShape shape : surface.facets.shapes)
    mesh.cell_types.push_back(static_cast<unsigned char>(shape));
  std::vector<Point> inside = surface.points;
  for (std::size_t i = 0; i < inside.size(); ++i)
    for (int axis = 0; axis < 3; ++axis)
      inside[i][axis] -= 1e-6 * bounds.longest_side() * surface.normals[i][axis];
  const bool has_flux = !flux.empty();
  if (has_flux) fields.push_back({"flux.n", flux});
  mesh.data = sample_at(surface.points, inside, fields, bounds.dimension);

  FieldMesh::PointData flux_vector;
  if (has_flux) {
    flux_vector = std::move(mesh.data.back());
    mesh.data.pop_back();
  }
  FieldMesh::PointData normal_flux{"flux.n", 1, {}}, normal{"normal", 3, {}}, piece{"piece", 1, {}};
  for (std::size_t i = 0; i < surface.points.size(); ++i) {
    double sum = 0;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      normal.values.push_back(surface.normals[i][axis]);
      if (has_flux) sum += surface.normals[i][axis] * flux_vector.values[3 * i + axis];
    }
    normal_flux.values.push_back(sum);
    piece.values.push_back(surface.primitives[i]);
  }
  if (has_flux) mesh.data.push_back(std::move(normal_flux));
  for (auto* data : {&normal, &piece}) mesh.data.push_back(std::move(*data));
  return mesh;
}

}  // namespace

ResultMeshes result_meshes(const ScalarProblem& problem, const Grid& grid,
                           const ScalarSolution& solution) {
  int most_cells = 1;
  for (int axis = 0; axis < grid.dimension(); ++axis)
    most_cells = std::max(most_cells, grid.cells(axis));
  TessellationOptions options;
  options.subdivisions =
      std::max(1, (problem.problem().outputs.resolution + most_cells - 1) / most_cells);
  const Tessellation tessellation = tessellate(problem.region(), grid, options);
  const std::vector<NamedField> fields = output_fields(problem, solution);
  ResultMeshes meshes{sample(tessellation, fields, grid.dimension()), {}};
  if (grid.dimension() > 1)
    meshes.boundary = boundary_mesh(boundary_surface(problem.region(), tessellation), fields,
                                    solution.results.flux, problem.bounds());
  return meshes;
}

}  // namespace rfm
