// Integrals in closed form, to rounding: measure, boundary and moments of bodies that every other
// program is measured by, for several positions of the grid.

#include <gmock/gmock.h>

#include "quadrature/integrate.hpp"
#include "tests/quadrature/standard_regions.hpp"

using namespace rfm;
using namespace rfm::test;

namespace {

template <class Function>
double integral(const DomainRule& rule, Function&& f) {
  return integrate(rule, [&](const QuadratureBlock& block, double* values) {
    for (int k = 0; k < block.count; ++k) {
      Point p{};
      for (int axis = 0; axis < rule.dimension(); ++axis) p[axis] = block.coordinates[axis][k];
      values[k] = f(p);
    }
  });
}
template <class Function>
double boundary_integral(const DomainRule& rule, Function&& f) {
  return integrate(rule.boundary(), [&](const QuadratureBlock& block, double* values) {
    for (int k = 0; k < block.count; ++k) {
      Point p{};
      for (int axis = 0; axis < rule.dimension(); ++axis) p[axis] = block.coordinates[axis][k];
      values[k] = f(p);
    }
  });
}

DomainRule rule_for(const Region& region, const Grid& grid, int points) {
  QuadratureOptions options;
  options.inside_points = options.cut_points = points;
  return make_domain_rule(RegionEvaluator(region), grid, options);
}

// Grids that neither fit the body nor its symmetry.
std::vector<Grid> grids(double half, int cells, int dimension) {
  std::vector<Grid> result;
  for (const double shift : {0.0, 0.031, -0.117}) {
    Box box = cube_box(half, dimension);
    for (int axis = 0; axis < dimension; ++axis) {
      box.low[axis] += shift * (axis + 1) / 2;
      box.high[axis] += shift * (2 - axis) / 2;
    }
    result.push_back(Grid(box, {cells, cells, cells}));
  }
  return result;
}

double moment(const Point& p) { return std::pow(p[0], 4) * p[1] * p[1]; }

TEST(KnownIntegrals, OfTheUnitDisk) {
  for (const Grid& grid : grids(1.2, 16, 2)) {
    const DomainRule rule = rule_for(disk(0, 0, 1), grid, 10);
    EXPECT_NEAR(rule.measure(), pi, 1e-13);
    EXPECT_NEAR(rule.boundary_measure(), 2 * pi, 1e-13);
    // ∫ r⁷ dr ∫ cos⁴ sin² dθ = (1/8) (π/8).
    EXPECT_NEAR(integral(rule, moment), pi / 64, 1e-13);
    EXPECT_NEAR(
        boundary_integral(rule, [](const Point& p) { return 3 * p[0] * p[0] - p[1] * p[1]; }),
        2 * pi, 1e-13);
  }
}

TEST(KnownIntegrals, OfAnEllipse) {
  // Half axes 1.5 and 0.75; the perimeter is 4 · 1.5 E(k² = 3/4).
  const Region ellipse = region_of(1 - square(x() / 1.5) - square(y() / 0.75), 2);
  for (const Grid& grid : grids(1.7, 24, 2)) {
    const DomainRule rule = rule_for(ellipse, grid, 12);
    EXPECT_NEAR(rule.measure(), 1.125 * pi, 1e-13);
    EXPECT_NEAR(rule.boundary_measure(), 7.26633616541076, 1e-13);
    EXPECT_NEAR(integral(rule, moment), std::pow(1.5, 5) * std::pow(0.75, 3) * pi / 64, 1e-13);
  }
}

TEST(KnownIntegrals, OfTheUnitBall) {
  for (const Grid& grid : grids(1.2, 10, 3)) {
    const DomainRule rule = rule_for(solid(1 - square(x()) - square(y()) - square(z())), grid, 12);
    EXPECT_NEAR(rule.measure(), 4 * pi / 3, 1e-13);
    EXPECT_NEAR(rule.boundary_measure(), 4 * pi, 1e-13);
    // The mean of x⁴y² over the sphere is 3 · 1 / (3 · 5 · 7), and ∫ r⁸ dr = 1/9.
    EXPECT_NEAR(integral(rule, moment), 4 * pi / 9 * 3 / 105, 1e-13);
    EXPECT_NEAR(boundary_integral(rule,
                                  [](const Point& p) {
                                    return 4 - 3 * p[0] * p[0] + 2 * p[1] * p[1] - p[2] * p[2];
                                  }),
                40 * pi / 3, 1e-13);
  }
}

TEST(KnownIntegrals, OfAnEllipsoid) {
  // Half axes a, b, c = 1.5, 0.75, 0.5. The surface by Legendre's formula, with 30 digits:
  // 2πc² + 2πab / sin φ (E(φ, k) sin² φ + F(φ, k) cos² φ), cos φ = c/a, k² = a²(b² − c²) / (b²(a² −
  // c²)).
  const Region ellipsoid = solid(1 - square(x() / 1.5) - square(y() / 0.75) - square(z() / 0.5));
  for (const Grid& grid : grids(1.7, 24, 3)) {
    const DomainRule rule = rule_for(ellipsoid, grid, 14);
    EXPECT_NEAR(rule.measure(), 4 * pi / 3 * 0.5625, 1e-13);
    EXPECT_NEAR(rule.boundary_measure(), 9.90182152049618327, 1e-13);
    EXPECT_NEAR(integral(rule, moment),
                4 * pi / 9 * 3 / 105 * std::pow(1.5, 5) * std::pow(0.75, 3) * 0.5, 1e-13);
  }
}

TEST(KnownIntegrals, OfTurnedCubeAndStarToRoundingOnEveryGrid) {
  for (int cells = 4; cells <= 12; ++cells) {
    const DomainRule plane = rule_for(star(0.45, 0.21), grid(1.7, cells), 2);
    EXPECT_NEAR(plane.measure() / star_area(0.45), 1, 1e-14) << cells;
    EXPECT_NEAR(plane.boundary_measure() / star_perimeter(0.45), 1, 1e-14) << cells;
    const DomainRule space = rule_for(rotated_cube(0.85), grid(1.7, cells, 3), 2);
    EXPECT_NEAR(space.measure() / 4.913, 1, 1e-14) << cells;
    EXPECT_NEAR(space.boundary_measure() / 17.34, 1, 1e-14) << cells;
    EXPECT_EQ(space.report().uncertified.boxes, 0) << cells;
  }
}

}  // namespace
