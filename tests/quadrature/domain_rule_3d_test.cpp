#include <gmock/gmock.h>

#include "core/level_function.hpp"
#include "quadrature/domain_rule.hpp"
#include "quadrature/integrate.hpp"
#include "tests/quadrature/regions.hpp"

using namespace rfm;
using namespace rfm::test;

namespace {

DomainRule rule_for(const Region& region, const Grid& grid, int points) {
  QuadratureOptions options;
  options.inside_points = options.cut_points = points;
  return make_domain_rule(RegionEvaluator(region), grid, options);
}

Region solid(const Field& level) { return region_of(level, 3); }

Region ball(double a, double b, double c, double r) {
  return solid(r * r - square(x() - a) - square(y() - b) - square(z() - c));
}

// Rows of a rotation by three angles.
std::array<Point, 3> rotation() {
  const double c = std::cos(0.3), s = std::sin(0.3), d = std::cos(0.5), e = std::sin(0.5);
  const double f = std::cos(0.7), g = std::sin(0.7);
  const Point u{c * d, s * d, e}, v{-s, c, 0}, w{-c * e, -s * e, d};
  std::array<Point, 3> rows{u, {}, {}};
  for (int i = 0; i < 3; ++i) {
    rows[1][i] = f * v[i] + g * w[i];
    rows[2][i] = -g * v[i] + f * w[i];
  }
  return rows;
}

Field along(const Point& direction) {
  return direction[0] * x() + direction[1] * y() + direction[2] * z();
}

Region turned_cube(double half) {
  const auto rows = rotation();
  Region cube = solid(half - along(rows[0])) & solid(half + along(rows[0]));
  for (int i = 1; i < 3; ++i)
    cube = cube & solid(half - along(rows[i])) & solid(half + along(rows[i]));
  return cube;
}

struct Body {
  const char* name;
  Region region;
  double volume;
  double area;
};
std::ostream& operator<<(std::ostream& out, const Body& body) { return out << body.name; }

Body turned_cylinder() {
  const auto rows = rotation();
  const Field a = along(rows[0]), b = along(rows[1]), c = along(rows[2]);
  return {"turned cylinder",
          solid(0.81 - square(a - 0.05) - square(b)) & solid(0.7 - c) & solid(0.6 + c),
          0.81 * pi * 1.3, 2 * 0.81 * pi + 1.8 * pi * 1.3};
}

class CurvedSolid : public testing::TestWithParam<Body> {};
INSTANTIATE_TEST_SUITE_P(
    DomainRule3D, CurvedSolid,
    testing::Values(Body{"ball", ball(0.1, -0.07, 0.03, 1), 4 * pi / 3, 4 * pi}, turned_cylinder(),
                    // Two cylinders: the edge curves cross the cells in every direction.
                    Body{"Steinmetz solid",
                         solid(1 - square(x() - 0.01) - square(y() - 0.02)) &
                             solid(1 - square(y() - 0.02) - square(z() - 0.03)),
                         16.0 / 3, 16}));

TEST_P(CurvedSolid, MeasuresAreExactToRoundingWithTenPoints) {
  const DomainRule rule = rule_for(GetParam().region, grid(1.7, 16, 3), 10);
  EXPECT_NEAR(rule.measure() / GetParam().volume, 1, 1e-14);
  EXPECT_NEAR(rule.boundary_measure() / GetParam().area, 1, 1e-13);
  EXPECT_LT(rule.report().divergence_defect, 1e-12);
}

class Polyhedron : public testing::TestWithParam<Body> {};
INSTANTIATE_TEST_SUITE_P(
    DomainRule3D, Polyhedron,
    testing::Values(Body{"turned cube", turned_cube(0.85), 4.913, 17.34},
                    // Four planes through one vertex.
                    Body{"pyramid",
                         solid(1 - z() - x() - 0.03) & solid(1 - z() + x() + 0.03) &
                             solid(1 - z() - y() + 0.02) & solid(1 - z() + y() - 0.02) & solid(z()),
                         4.0 / 3, 4 + 4 * std::sqrt(2.0)},
                    // A cube with a turned cube through its face: vertices and edges cross.
                    Body{"cube without cube",
                         (solid(1 - x()) & solid(1 + x()) & solid(1 - y()) & solid(1 + y()) &
                          solid(1 - z()) & solid(1 + z())) -
                             turned_cube(0.4),
                         8 - 0.512, 24 + 6 * 0.64}));

TEST_P(Polyhedron, MeasuresAreExactForEveryGrid) {
  for (const int cells : {1, 4, 7}) {
    const DomainRule rule = rule_for(GetParam().region, grid(1.7, cells, 3), 2);
    EXPECT_NEAR(rule.measure() / GetParam().volume, 1, 2e-14) << cells;
    EXPECT_NEAR(rule.boundary_measure() / GetParam().area, 1, 2e-14) << cells;
    EXPECT_LT(rule.report().divergence_defect, 1e-13) << cells;
  }
}

TEST(DomainRule3D, FacesOnGridPlanesAndOnSidesOfTheGridAreCountedOnce) {
  const Region cube = solid(1 - x()) & solid(1 + x()) & solid(1 - y()) & solid(1 + y()) &
                      solid(1 - z()) & solid(1 + z());
  for (const double half : {1.0, 2.0}) {
    const DomainRule rule = rule_for(cube, grid(half, 4, 3), 2);
    EXPECT_NEAR(rule.measure(), 8, 1e-14);
    for (int side = 0; side < 6; ++side) EXPECT_NEAR(rule.boundary_measure(side), 4, 1e-14);
    EXPECT_EQ(rule.report().cut_cells, 0);
    EXPECT_EQ(rule.report().inside_cells, half == 1 ? 64 : 8);
    for (const int cell : rule.boundary().cells) EXPECT_EQ(rule.state(cell), CellState::inside);
  }
}

TEST(DomainRule3D, FacesOf1MinusXSquaredAreCountedOnce) {
  const Region cube = solid(1 - square(x())) & solid(1 - square(y())) & solid(1 - square(z()));
  for (const double half : {1.0, 1.3, 2.0}) {
    const DomainRule rule = rule_for(cube, grid(half, 4, 3), 3);
    EXPECT_NEAR(rule.measure(), 8, 1e-14);
    for (int side = 0; side < 3; ++side) EXPECT_NEAR(rule.boundary_measure(side), 8, 1e-13);
    EXPECT_EQ(rule.report().uncertified.boxes, 0);
  }
}

TEST(DomainRule3D, NormalsPointOutward) {
  const DomainRule rule =
      rule_for(ball(0, 0, 0, 1) - ball(0.1, 0.2, -0.1, 0.4), grid(1.1, 6, 3), 3);
  const SurfacePoints& points = rule.boundary().points;
  ASSERT_GT(points.size(), 0);
  for (int i = 0; i < points.size(); ++i) {
    const Point p = points.point(i), n = points.normal(i);
    const bool outer = points.numbers[i] == 0;
    const Point center = outer ? Point{} : Point{0.1, 0.2, -0.1};
    for (int axis = 0; axis < 3; ++axis)
      EXPECT_NEAR(n[axis], (p[axis] - center[axis]) / (outer ? 1 : -0.4), 1e-13);
    EXPECT_GT(points.weights[i], 0);
  }
  for (const double weight : rule.cut_points().weights) EXPECT_GT(weight, 0);
}

TEST(DomainRule3D, IntegratesMomentsOfABall) {
  // ∫ x² over the unit ball about c: 4π/15 + c₀² 4π/3.
  const DomainRule rule = rule_for(ball(0.1, -0.07, 0.03, 1), grid(1.3, 16, 3), 8);
  const double moment = integrate(rule, [](const QuadratureBlock& block, double* values) {
    for (int k = 0; k < block.count; ++k)
      values[k] = block.coordinates[0][k] * block.coordinates[0][k];
  });
  EXPECT_NEAR(moment, 4 * pi / 15 + 0.01 * 4 * pi / 3, 1e-13);
  const double surface =
      integrate(rule.boundary(), [](const QuadratureBlock& block, double* values) {
        for (int k = 0; k < block.count; ++k)
          values[k] = block.coordinates[2][k] * block.normals[2][k];
      });
  EXPECT_NEAR(surface, 4 * pi / 3, 1e-12);
}

TEST(DomainRule3D, InterfacesSplitVolumeAndBoundary) {
  // The plane z = 0.3 + 0.2 x cuts a cap of height 1 − d from the unit ball, d = 0.3 / √1.04.
  std::vector<LevelFunction> interfaces;
  interfaces.emplace_back(z() - 0.3 - 0.2 * x(), 3);
  QuadratureOptions options;
  options.inside_points = options.cut_points = 8;
  const DomainRule rule =
      make_domain_rule(RegionEvaluator(ball(0, 0, 0, 1)), grid(1, 9, 3), options, interfaces);
  const double d = 0.3 / std::sqrt(1.04), cap = pi * (1 - d) * (1 - d) * (2 + d) / 3;
  const auto above = [](const QuadratureBlock& block, double* values) {
    for (int k = 0; k < block.count; ++k)
      values[k] = block.coordinates[2][k] > 0.3 + 0.2 * block.coordinates[0][k];
  };
  EXPECT_NEAR(integrate(rule, above), cap, 1e-10);
  EXPECT_NEAR(integrate(rule.boundary(), above), 2 * pi * (1 - d), 1e-8);
  EXPECT_NEAR(rule.interfaces().measure(0), pi * (1 - d * d), 1e-9);
  EXPECT_NEAR(rule.measure(), 4 * pi / 3, 1e-10);
}

TEST(DomainRule3D, BreakpointsSplitCells) {
  // ∫ |z − 0.137| over the cube |x|, |y|, |z| ≤ 1: (1 + 0.137²) · 4.
  const Region cube = solid(1 - square(x())) & solid(1 - square(y())) & solid(1 - square(z()));
  QuadratureOptions options;
  options.inside_points = options.cut_points = 2;
  options.breakpoints[2] = {0.137};
  const DomainRule rule = make_domain_rule(RegionEvaluator(cube), grid(1.2, 5, 3), options);
  const double integral = integrate(rule, [](const QuadratureBlock& block, double* values) {
    for (int k = 0; k < block.count; ++k) values[k] = std::fabs(block.coordinates[2][k] - 0.137);
  });
  EXPECT_NEAR(integral, 4 * (1 + 0.137 * 0.137), 1e-13);
}

}  // namespace
