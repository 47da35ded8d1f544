#include "quadrature/tessellation.hpp"

#include <gmock/gmock.h>

#include "core/error.hpp"
#include "tests/quadrature/regions.hpp"

using namespace rfm;
using namespace rfm::test;

namespace {

Tessellation tessellation_of(const Region& region, const Grid& grid, int subdivisions) {
  TessellationOptions options;
  options.subdivisions = subdivisions;
  return tessellate(RegionEvaluator(region), grid, options);
}

// Signed: positive for counter-clockwise elements.
double element_area(const Tessellation& t, int element) {
  const auto vertices = t.elements.vertices(element);
  double area = 0;
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    const Point &p = t.vertices[vertices[i]], &q = t.vertices[vertices[(i + 1) % vertices.size()]];
    area += 0.5 * (p[0] * q[1] - q[0] * p[1]);
  }
  return area;
}

double area(const Tessellation& t) {
  double sum = 0;
  for (int e = 0; e < t.elements.size(); ++e) sum += element_area(t, e);
  return sum;
}

// Length of the boundary, and the area it encloses by Green's formula ∮ (x dy − y dx) / 2.
std::array<double, 2> boundary_length_and_area(const Tessellation& t) {
  std::array<double, 2> sums{};
  for (int e = 0; e < t.boundary.size(); ++e) {
    const auto ends = t.boundary.vertices(e);
    const Point &p = t.vertices[ends[0]], &q = t.vertices[ends[1]];
    sums[0] += std::hypot(q[0] - p[0], q[1] - p[1]);
    sums[1] += 0.5 * (p[0] * q[1] - q[0] * p[1]);
  }
  return sums;
}

TEST(Tessellation, OfAPolygonIsExact) {
  for (const int cells : {1, 4, 7, 16})
    for (const int subdivisions : {1, 3}) {
      const Tessellation t = tessellation_of(star(0.45, 0.21), grid(1.7, cells), subdivisions);
      EXPECT_NEAR(area(t), star_area(0.45), 1e-13);
      const auto [length, enclosed] = boundary_length_and_area(t);
      EXPECT_NEAR(length, star_perimeter(0.45), 1e-13);
      EXPECT_NEAR(enclosed, star_area(0.45), 1e-13);
    }
}

TEST(Tessellation, ElementsAreCounterClockwiseAndInTheirCell) {
  const Region region = disk(0, 0, 1) - disk(0.6, 0.3, 0.7);
  const Grid cells = grid(1.3, 9);
  const Tessellation t = tessellation_of(region, cells, 2);
  ASSERT_EQ(t.grid_cells.size(), static_cast<std::size_t>(t.elements.size()));
  for (int e = 0; e < t.elements.size(); ++e) {
    EXPECT_GT(element_area(t, e), 0);
    const Box cell = cells.cell(cells.position(t.grid_cells[e]));
    for (const int v : t.elements.vertices(e)) EXPECT_TRUE(cell.contains(t.vertices[v]));
  }
}

TEST(Tessellation, VerticesOfTheBoundaryLieOnTheirPrimitive) {
  const Region region = disk(0, 0, 1) - disk(0.6, 0.3, 0.7);
  const RegionEvaluator evaluator(region);
  const Tessellation t = tessellation_of(region, grid(1.3, 9), 3);
  ASSERT_GT(t.boundary.size(), 0);
  ASSERT_EQ(t.primitives.size(), static_cast<std::size_t>(t.boundary.size()));
  for (int e = 0; e < t.boundary.size(); ++e)
    for (const int v : t.boundary.vertices(e))
      EXPECT_NEAR(evaluator.level(t.primitives[e]).value(t.vertices[v]), 0, 2e-15);
}

TEST(Tessellation, CornersAreVertices) {
  const Tessellation t = tessellation_of(turned_square(0.9, 0.3), grid(1.7, 7), 2);
  for (int k = 0; k < 4; ++k) {
    const double angle = 0.3 + pi / 4 + k * pi / 2, r = 0.9 * std::numbers::sqrt2;
    double nearest = 1;
    for (const Point& p : t.vertices)
      nearest =
          std::min(nearest, std::hypot(p[0] - r * std::cos(angle), p[1] - r * std::sin(angle)));
    EXPECT_LT(nearest, 1e-14);
  }
}

TEST(Tessellation, AreasOfCurvedBodiesConvergeWithOrderTwo) {
  const Region region = disk(0.1, -0.07, 1);
  const auto error = [&](int cells) {
    const Tessellation t = tessellation_of(region, grid(1.7, cells), 2);
    const auto [length, enclosed] = boundary_length_and_area(t);
    EXPECT_NEAR(enclosed, area(t), 1e-12);
    EXPECT_LT(length, 2 * pi);
    return pi - area(t);
  };
  const double coarse = error(16), fine = error(64);
  EXPECT_LT(coarse, 0.01);
  EXPECT_NEAR(std::log(coarse / fine) / std::log(4.0), 2, 0.15);
}

TEST(Tessellation, BoundaryOnGridLinesAppearsOnce) {
  const Region region = region_of(1 - square(x()), 2) & region_of(1 - square(y()), 2);
  for (const double half : {1.0, 2.0}) {
    const Tessellation t = tessellation_of(region, grid(half, 4), 1);
    EXPECT_NEAR(area(t), 4, 1e-15);
    const auto [length, enclosed] = boundary_length_and_area(t);
    EXPECT_NEAR(length, 8, 1e-14);
    EXPECT_NEAR(enclosed, 4, 1e-14);
  }
}

TEST(Tessellation, ClosesInRotatedFrames) {
  const Region region =
      region_of(y() - 0.05 - square(x() - 0.05), 2) & region_of(x() - 0.05 - square(y() - 0.05), 2);
  const Tessellation t = tessellation_of(region, grid(1.7, 16), 8);
  EXPECT_NEAR(area(t), 1.0 / 3, 2e-4);
  EXPECT_NEAR(boundary_length_and_area(t)[1], area(t), 1e-13);
  EXPECT_EQ(t.uncertified.boxes, 0);
}

TEST(Tessellation, InterfacesSeparateElements) {
  std::vector<LevelFunction> interfaces;
  interfaces.emplace_back(x() - 0.123 * y() - 0.05, 2);
  const Tessellation t = tessellate(RegionEvaluator(disk(0, 0, 1)), grid(1.1, 6), {}, interfaces);
  for (int e = 0; e < t.elements.size(); ++e) {
    double low = 0, high = 0;
    for (const int v : t.elements.vertices(e)) {
      low = std::min(low, interfaces[0].value(t.vertices[v]));
      high = std::max(high, interfaces[0].value(t.vertices[v]));
    }
    EXPECT_LT(std::min(-low, high), 1e-14);
  }
}

TEST(Tessellation, InOneDimensionIsSegments) {
  const Tessellation t = tessellation_of(region_of((x() + 0.3) * (0.5 - x()), 1), grid(1, 4, 1), 2);
  double length = 0;
  for (int e = 0; e < t.elements.size(); ++e) {
    EXPECT_EQ(t.elements.shapes[e], ElementShape::segment);
    const auto ends = t.elements.vertices(e);
    length += t.vertices[ends[1]][0] - t.vertices[ends[0]][0];
  }
  EXPECT_NEAR(length, 0.8, 1e-15);
}

TEST(Tessellation, FewerThanOneSubdivisionIsRefused) {
  EXPECT_THROW(tessellation_of(disk(0, 0, 1), grid(1, 2), 0), InvalidArgument);
}

}  // namespace
