#include <gmock/gmock.h>

#include "quadrature/tessellation.hpp"
#include "tests/quadrature/regions.hpp"

using namespace rfm;
using namespace rfm::test;

namespace {

Region solid(const Field& level) { return region_of(level, 3); }

Tessellation tessellation_of(const Region& region, const Grid& grid, int subdivisions) {
  TessellationOptions options;
  options.subdivisions = subdivisions;
  return tessellate(RegionEvaluator(region), grid, options);
}

// Six times the signed volume of a tetrahedron.
double determinant(const Point& a, const Point& b, const Point& c, const Point& d) {
  const auto minus = [&](const Point& p) { return Point{p[0] - a[0], p[1] - a[1], p[2] - a[2]}; };
  const Point u = minus(b), v = minus(c), w = minus(d);
  return u[0] * (v[1] * w[2] - v[2] * w[1]) + u[1] * (v[2] * w[0] - v[0] * w[2]) +
         u[2] * (v[0] * w[1] - v[1] * w[0]);
}

// A hexahedron is taken apart into six tetrahedra about its diagonal 0–6.
double element_volume(const Tessellation& t, int element) {
  const auto v = t.elements.vertices(element);
  const auto six = [&](int a, int b, int c, int d) {
    return determinant(t.vertices[v[a]], t.vertices[v[b]], t.vertices[v[c]], t.vertices[v[d]]);
  };
  if (t.elements.shapes[element] == ElementShape::tetrahedron) return six(0, 1, 2, 3) / 6;
  return (six(0, 1, 2, 6) + six(0, 2, 3, 6) + six(0, 3, 7, 6) + six(0, 7, 4, 6) + six(0, 4, 5, 6) +
          six(0, 5, 1, 6)) /
         6;
}

double volume(const Tessellation& t) {
  double sum = 0;
  for (int e = 0; e < t.elements.size(); ++e) sum += element_volume(t, e);
  return sum;
}

struct Surface3D {
  double area = 0;
  double enclosed = 0;
};
// Area of the boundary, and the volume it encloses by the divergence theorem.
Surface3D surface(const Tessellation& t) {
  Surface3D sums;
  for (int e = 0; e < t.boundary.size(); ++e) {
    const auto v = t.boundary.vertices(e);
    const Point &a = t.vertices[v[0]], &b = t.vertices[v[1]], &c = t.vertices[v[2]];
    sums.enclosed += determinant({}, a, b, c) / 6;
    const Point u{b[0] - a[0], b[1] - a[1], b[2] - a[2]}, w{c[0] - a[0], c[1] - a[1], c[2] - a[2]};
    sums.area += 0.5 * std::hypot(u[1] * w[2] - u[2] * w[1], u[2] * w[0] - u[0] * w[2],
                                  u[0] * w[1] - u[1] * w[0]);
  }
  return sums;
}

Region turned_cube() {
  const double c = std::cos(0.3), s = std::sin(0.3), d = std::cos(0.5), e = std::sin(0.5);
  const Field u = c * d * x() + s * d * y() + e * z(), v = c * y() - s * x(),
              w = d * z() - c * e * x() - s * e * y();
  return solid(0.85 - u) & solid(0.85 + u) & solid(0.85 - v) & solid(0.85 + v) & solid(0.85 - w) &
         solid(0.85 + w);
}

TEST(Tessellation3D, OfAPolyhedronIsExact) {
  for (const int cells : {1, 4, 7})
    for (const int subdivisions : {1, 2}) {
      const Tessellation t = tessellation_of(turned_cube(), grid(1.7, cells, 3), subdivisions);
      EXPECT_NEAR(volume(t), 4.913, 1e-11);
      EXPECT_NEAR(surface(t).area, 17.34, 1e-10);
      EXPECT_NEAR(surface(t).enclosed, 4.913, 1e-10);
    }
}

TEST(Tessellation3D, OfABoxOnGridPlanesHasEachFaceOnce) {
  const Region cube = solid(1 - square(x())) & solid(1 - square(y())) & solid(1 - square(z()));
  for (const double half : {1.0, 1.3, 2.0}) {
    const Tessellation t = tessellation_of(cube, grid(half, 4, 3), 1);
    EXPECT_NEAR(volume(t), 8, 1e-13);
    EXPECT_NEAR(surface(t).area, 24, 1e-13);
    EXPECT_NEAR(surface(t).enclosed, 8, 1e-13);
  }
}

TEST(Tessellation3D, VolumeAndAreaOfABallConvergeWithOrderTwo) {
  const Region ball = solid(1 - square(x() - 0.1) - square(y()) - square(z() - 0.03));
  const auto errors = [&](int cells) {
    const Tessellation t = tessellation_of(ball, grid(1.3, cells, 3), 1);
    EXPECT_EQ(t.uncertified.boxes, 0);
    // Between cells elements need not match: curved faces leave gaps of second order.
    EXPECT_NEAR(surface(t).enclosed, volume(t), 0.3 / (cells * cells));
    return std::array{4 * pi / 3 - volume(t), 4 * pi - surface(t).area};
  };
  const auto coarse = errors(12), fine = errors(32);
  for (int k = 0; k < 2; ++k)
    EXPECT_NEAR(std::log(coarse[k] / fine[k]) / std::log(32.0 / 12), 2, 0.15);
  EXPECT_LT(fine[0], 0.02);
}

TEST(Tessellation3D, VerticesOfTheBoundaryLieOnTheirPrimitive) {
  const Region region = solid(1 - square(x() - 0.1) - square(y()) - square(z() - 0.03)) -
                        solid(0.2 - square(y()) - square(z()));
  const RegionEvaluator evaluator(region);
  const Tessellation t = tessellation_of(region, grid(1.3, 7, 3), 2);
  ASSERT_GT(t.boundary.size(), 0);
  for (int e = 0; e < t.boundary.size(); ++e)
    for (const int v : t.boundary.vertices(e))
      EXPECT_NEAR(evaluator.level(t.primitives[e]).value(t.vertices[v]), 0, 1e-10);
}

TEST(Tessellation3D, ElementsAreNotInvertedAndStayInTheirCell) {
  const Region region = turned_cube() - solid(0.25 - square(x() - 0.5) - square(y()) - square(z()));
  const Grid cells = grid(1.3, 5, 3);
  const Tessellation t = tessellation_of(region, cells, 1);
  for (int e = 0; e < t.elements.size(); ++e) {
    EXPECT_GT(element_volume(t, e), -1e-15);
    const Box cell = cells.cell(cells.position(t.grid_cells[e]));
    for (const int v : t.elements.vertices(e))
      for (int axis = 0; axis < 3; ++axis) {
        EXPECT_GE(t.vertices[v][axis], cell.low[axis] - 1e-14);
        EXPECT_LE(t.vertices[v][axis], cell.high[axis] + 1e-14);
      }
  }
}

TEST(Tessellation3D, VerticesOfAPolyhedronAreVertices) {
  const Tessellation t = tessellation_of(turned_cube(), grid(1.7, 5, 3), 1);
  const double c = std::cos(0.3), s = std::sin(0.3), d = std::cos(0.5), e = std::sin(0.5);
  for (int k = 0; k < 8; ++k) {
    const double u = k & 1 ? 0.85 : -0.85, v = k & 2 ? 0.85 : -0.85, w = k & 4 ? 0.85 : -0.85;
    const Point corner{c * d * u - s * v - c * e * w, s * d * u + c * v - s * e * w, e * u + d * w};
    double nearest = 1;
    for (const Point& p : t.vertices)
      nearest = std::min(nearest, std::hypot(p[0] - corner[0], p[1] - corner[1], p[2] - corner[2]));
    EXPECT_LT(nearest, 1e-11);
  }
}

}  // namespace
