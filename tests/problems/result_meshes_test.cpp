#include "problems/result_meshes.hpp"

#include <gmock/gmock.h>

#include <cmath>

#include "problems/reader.hpp"

using namespace rfm;

namespace {

const FieldMesh::PointData& data_of(const FieldMesh& mesh, const std::string& name) {
  for (const auto& data : mesh.data)
    if (data.name == name) return data;
  throw std::out_of_range(name);
}

ResultMeshes solved(const std::string& text) {
  const Problem file = read_problem(make_source("case.yaml", text));
  const ScalarProblem problem(file);
  const Grid grid = problem.grid();
  return result_meshes(problem, grid, problem.solve(grid));
}

// u is in the space of the splines: what remains is the error of quadrature on few cells, which the
// gradient shows most where a spline reaches into the domain by little.
constexpr double flux_tolerance = 1e-3;

// −Δu = 2n with u = 0 on the unit ball of dimension n is solved by u = 1 − |x|², and n·∇u = −2; in
// the hole u is prescribed as 1 − |x|² too, the outward normal points to its centre.
void expect_quadratic(const ResultMeshes& meshes, int dimension) {
  const FieldMesh& boundary = meshes.boundary;
  ASSERT_GT(boundary.points.size(), 20u);
  const auto &u = data_of(boundary, "u"), &flux = data_of(boundary, "flux.n"),
             &normal = data_of(boundary, "normal"), &piece = data_of(boundary, "piece");
  EXPECT_EQ(normal.components, 3);
  int on_hole = 0;
  for (std::size_t i = 0; i < boundary.points.size(); ++i) {
    const Point& p = boundary.points[i];
    const double square = p[0] * p[0] + p[1] * p[1] + p[2] * p[2];
    EXPECT_NEAR(u.values[i], 1 - square, 1e-5);
    double expected = 0;
    for (int axis = 0; axis < dimension; ++axis)
      expected += -2 * p[axis] * normal.values[3 * i + axis];
    EXPECT_NEAR(flux.values[i], expected, flux_tolerance);
    const double outward = (p[0] * normal.values[3 * i] + p[1] * normal.values[3 * i + 1] +
                            p[2] * normal.values[3 * i + 2]);
    if (piece.values[i] == 0) {
      EXPECT_NEAR(outward, 1, 1e-8);
      EXPECT_NEAR(flux.values[i], -2, flux_tolerance);
    } else {
      EXPECT_EQ(piece.values[i], 1);
      EXPECT_LT(outward, 0.2);
      ++on_hole;
    }
  }
  EXPECT_GT(on_hole, 5);
  for (const unsigned char type : boundary.cell_types) EXPECT_EQ(type, dimension == 2 ? 3 : 5);
  EXPECT_EQ(boundary.cell_begin.size(), boundary.cell_types.size() + 1);
}

TEST(ResultMeshes, HaveFluxAndNormalsOnTheBoundaryOfAPlaneDomain) {
  expect_quadratic(solved(R"(
dimension: 2
geometry:
  shapes:
    disk: {circle: {center: [0, 0], radius: 1}}
    hole: {circle: {center: [0.2, 0.1], radius: 0.3}}
  domain: disk - hole
physics: {type: poisson, source: 4}
conditions: [{at: disk, value: 0}, {at: hole, value: "1 - x^2 - y^2", enforce: weak}]
discretization: {basis: {bspline: 3, cells: 12}}
outputs: {vtu: {resolution: 24}}
)"),
                   2);
}

TEST(ResultMeshes, HaveFluxAndNormalsOnTheBoundaryOfABody) {
  expect_quadratic(solved(R"(
dimension: 3
geometry:
  shapes:
    ball: {sphere: {center: [0, 0, 0], radius: 1}}
    hole: {sphere: {center: [0.2, 0.1, 0], radius: 0.3}}
  domain: ball - hole
physics: {type: poisson, source: 6}
conditions: [{at: ball, value: 0}, {at: hole, value: "1 - x^2 - y^2 - z^2", enforce: weak}]
discretization: {basis: {bspline: 2, cells: 8}}
outputs: {vtu: {resolution: 16}}
)"),
                   3);
}

TEST(ResultMeshes, HaveNoBoundaryOnTheLine) {
  EXPECT_EQ(solved(R"(
dimension: 1
geometry: {shapes: {bar: {box: {min: [0], max: [2]}}}, domain: bar}
physics: {type: poisson, source: 1}
conditions: [{at: bar, value: 0}]
)")
                .boundary.cell_count(),
            0);
}

}  // namespace
