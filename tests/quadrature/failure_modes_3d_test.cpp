// Situations in space in which surfaces touch, meet in many or in singular points.

#include <gmock/gmock.h>
#include <tbb/global_control.h>

#include "quadrature/domain_rule.hpp"
#include "tests/quadrature/regions.hpp"

using namespace rfm;
using namespace rfm::test;

namespace {

Region solid(const Field& level) { return region_of(level, 3); }

struct Errors {
  double volume;
  double area;
  QuadratureReport report;
};

Errors errors(const Region& region, double volume, double area, int cells, int points) {
  QuadratureOptions options;
  options.inside_points = options.cut_points = points;
  const DomainRule rule = make_domain_rule(RegionEvaluator(region), grid(1.7, cells, 3), options);
  return {std::fabs(rule.measure() / volume - 1), std::fabs(rule.boundary_measure() / area - 1),
          rule.report()};
}

TEST(FailureModes3D, FilletTangentToPlanesAlongLines) {
  // A slab |z| ≤ 1/2 with a half-round end: the cylinder touches both planes along lines.
  const Region band = solid(1 - square(y()));
  const Region region =
      (solid(0.5 - z()) & solid(0.5 + z()) & solid(0.8 - x()) & solid(0.8 + x()) & band) |
      (solid(0.25 - square(x() - 0.8) - square(z())) & band);
  // Two flanks, two planes, the round and the straight end.
  const double volume = 3.2 + pi / 4, area = 2 * (1.6 + pi / 8) + 2 * 3.2 + pi + 2;
  const Errors error = errors(region, volume, area, 8, 10);
  EXPECT_LT(error.volume, 1e-11);
  EXPECT_LT(error.area, 1e-9);
  EXPECT_EQ(error.report.uncertified.boxes, 0);
}

TEST(FailureModes3D, CylindersTangentAlongALine) {
  const Region region =
      (solid(1 - square(x()) - square(y())) -
       solid(0.25 - square(x() - 0.5 * std::cos(0.4)) - square(y() - 0.5 * std::sin(0.4)))) &
      solid(1 - z()) & solid(1 + z());
  const double volume = 1.5 * pi, area = 6 * pi + 1.5 * pi;
  const Errors coarse = errors(region, volume, area, 8, 8);
  EXPECT_LT(coarse.volume, 1e-6);
  EXPECT_LT(coarse.area, 1e-5);
  const Errors fine = errors(region, volume, area, 24, 8);
  EXPECT_LT(fine.volume, 1e-12);
  EXPECT_LT(fine.area, 1e-10);
  EXPECT_EQ(fine.report.uncertified.boxes, 0);
}

TEST(FailureModes3D, CylindersTangentOnThePlanesOrInTheMiddlesOfCellsKeepTheirArea) {
  const Region region =
      (solid(1 - square(x()) - square(y())) - solid(0.25 - square(x() - 0.5) - square(y()))) &
      solid(0.5 - z()) & solid(0.5 + z());
  const double volume = 0.75 * pi, area = 3 * pi + 1.5 * pi;
  for (int cells = 3; cells <= 11; ++cells)
    for (const int points : {3, 5, 6, 7, 8}) {
      QuadratureOptions options;
      options.inside_points = options.cut_points = points;
      const Grid cell_grid({3, {-1, -1, -0.5}, {1, 1, 0.5}}, {cells, cells, cells / 2 + 1});
      const DomainRule rule = make_domain_rule(RegionEvaluator(region), cell_grid, options);
      const QuadratureReport& report = rule.report();
      EXPECT_EQ(report.uncertified.boxes, 0);
      EXPECT_NEAR(rule.measure(), volume, report.order_difference.volume + 1e-12)
          << cells << " cells, " << points << " points";
      EXPECT_NEAR(rule.boundary_measure(), area, report.order_difference.boundary + 1e-11)
          << cells << " cells, " << points << " points";
    }
}

TEST(FailureModes3D, BallsTangentInTheMiddleOfACellKeepTheirArea) {
  const Region region = solid(1 - square(x()) - square(y()) - square(z())) -
                        solid(0.25 - square(x()) - square(y()) - square(z() - 0.5));
  for (const int cells : {5, 7, 8})
    for (const int points : {5, 6, 7}) {
      QuadratureOptions options;
      options.inside_points = options.cut_points = points;
      const DomainRule rule = make_domain_rule(RegionEvaluator(region), grid(1, cells, 3), options);
      const QuadratureReport& report = rule.report();
      EXPECT_NEAR(rule.measure(), 4 * pi / 3 * 0.875,
                  report.order_difference.volume + report.uncertified.measure + 1e-12)
          << cells << " cells, " << points << " points";
      EXPECT_NEAR(rule.boundary_measure(), 5 * pi,
                  report.order_difference.boundary + report.uncertified.boundary + 1e-11)
          << cells << " cells, " << points << " points";
    }
}

TEST(FailureModes3D, PlaneTangentToATorusAlongACircle) {
  // The plane cuts nothing off: volume and area are those of the torus.
  const Region torus =
      solid(0.16 - square(sqrt(square(x()) + square(y())) - 1) - square(z() - 0.02));
  const Errors error = errors(torus & solid(0.42 - z()), 0.32 * pi * pi, 1.6 * pi * pi, 8, 6);
  EXPECT_LT(error.volume, 1e-7);
  EXPECT_LT(error.area, 1e-6);
  EXPECT_EQ(error.report.uncertified.boxes, 0);
}

TEST(FailureModes3D, BallsTangentInOnePoint) {
  const Region region = solid(1 - square(x()) - square(y()) - square(z())) -
                        solid(0.25 - square(x() - 0.3) - square(y() - 0.4 * std::cos(0.3)) -
                              square(z() - 0.4 * std::sin(0.3)));
  const Errors error = errors(region, 4 * pi / 3 * 0.875, 5 * pi, 8, 8);
  EXPECT_LT(error.volume, 1e-8);
  EXPECT_LT(error.area, 1e-6);
  EXPECT_LT(error.report.uncertified.measure, 1e-3);
}

TEST(FailureModes3D, ApexOfAConeOnTheBoundary) {
  const Field r = square(x() - 0.03) + square(y() - 0.02);
  const double area = pi + pi * std::sqrt(2.0);
  const Errors root = errors(solid(z() - sqrt(r)) & solid(1 - z()), pi / 3, area, 8, 8);
  EXPECT_LT(root.volume, 1e-8);
  EXPECT_LT(root.area, 1e-5);
  EXPECT_GT(root.report.uncertified.boxes, 0);
  EXPECT_LT(root.report.uncertified.measure, 1e-4);
  const Errors quadric =
      errors(solid(square(z()) - r) & solid(1 - z()) & solid(z()), pi / 3, area, 8, 8);
  EXPECT_LT(quadric.volume, 1e-8);
  EXPECT_LT(quadric.area, 1e-5);
}

TEST(FailureModes3D, FourFacesInEachVertexOfAnOctahedron) {
  // Vertices on grid planes, where neighbouring cells share them.
  Region octahedron = solid(1 - x() - y() - z());
  for (int k = 1; k < 8; ++k)
    octahedron = octahedron & solid(1 - (k & 1 ? -1 : 1) * x() - (k & 2 ? -1 : 1) * y() -
                                    (k & 4 ? -1 : 1) * z());
  for (const int cells : {3, 4}) {
    const Errors error = errors(octahedron, 4.0 / 3, 4 * std::sqrt(3.0), cells, 2);
    EXPECT_LT(error.volume, 1e-13);
    EXPECT_LT(error.area, 1e-13);
    EXPECT_LT(error.report.divergence_defect, 1e-13);
  }
}

TEST(FailureModes3D, CoincidentSurfacesAndComplementsLeaveNoCrack) {
  const Field f = 1 - square(x()) - square(y()) - square(z());
  const Field plane = z() - 0.1 - 0.3 * x();
  const Region ball = solid(f) & solid(3 * f);
  const Region region = (ball & solid(plane)) | (ball & solid(-2 * plane));
  const Errors error = errors(region, 4 * pi / 3, 4 * pi, 8, 10);
  EXPECT_LT(error.volume, 1e-11);
  EXPECT_LT(error.area, 1e-9);
}

// Two unit cylinders cross along both diagonals of the cells in the middle of odd grids: all that
// the two graphs differ by vanishes at their centres and on the diagonals.
TEST(FailureModes3D, SurfacesThatCrossAlongTheDiagonalsOfCellsAreTwo) {
  const Region both = solid(1 - square(x()) - square(y())) & solid(1 - square(y()) - square(z()));
  for (const int cells : {5, 8, 9}) {
    QuadratureOptions options;
    options.inside_points = options.cut_points = 6;
    const DomainRule rule = make_domain_rule(RegionEvaluator(both), grid(1, cells, 3), options);
    EXPECT_NEAR(rule.measure(), 16.0 / 3, 2e-10) << cells;
    EXPECT_NEAR(rule.boundary_measure(), 16, 1e-8) << cells;
  }
}

// z > max(x², y²) up to z = 1: 4 − ∫∫ max(x², y²) = 2, polynomials on either side of the diagonals.
// The border of the grid is moved by 2⁻⁴⁰ of a cell.
TEST(FailureModes3D, TwoParabolicSheetsAreExactOnOddGrids) {
  const Region bowl = solid(z() - square(x())) & solid(z() - square(y()));
  for (const int points : {2, 3}) {
    QuadratureOptions options;
    options.inside_points = options.cut_points = points;
    const DomainRule rule = make_domain_rule(RegionEvaluator(bowl), grid(1, 5, 3), options);
    EXPECT_NEAR(rule.measure(), 2, 1e-11) << points;
  }
}

// Volume points per cut cell; 64 in a box that needs no division.
int points_per_cell(const Region& region, int cells) {
  QuadratureOptions options;
  options.inside_points = options.cut_points = 4;
  const DomainRule rule = make_domain_rule(RegionEvaluator(region), grid(1.7, cells, 3), options);
  EXPECT_EQ(rule.report().uncertified.boxes, 0);
  return rule.cut_points().size() / rule.report().cut_cells;
}

TEST(FailureModes3D, EdgesThroughFacesOfCoarseCellsStayCheap) {
  // The edges leave cells where the traces of the two surfaces are graphs over different axes; in
  // the second body the surfaces also come near to each other.
  const Region ball = solid(1 - square(x() - 0.1) - square(y()) - square(z() - 0.03));
  EXPECT_LT(points_per_cell(ball & solid(0.8 - square(y()) - square(z())), 6), 600);
  EXPECT_LT(points_per_cell(ball & solid(0.3 - square(y() + 0.4) - square(z() - 0.2)), 6), 900);
}

TEST(FailureModes3D, CoincidentSurfacesCostNotMuchMoreThanOne) {
  const Field f = 1 - square(x()) - square(y()) - square(z());
  EXPECT_LT(points_per_cell(solid(f) & solid(3 * f), 8), 3 * points_per_cell(solid(f), 8));
}

TEST(FailureModes3D, MeasuresHoldForEveryPositionOfTheGrid) {
  // A block with a cylindrical bore and a spherical dent, turned and moved.
  for (int k = 0; k < 12; ++k) {
    const double t = 0.53 * k, c = std::cos(t), s = std::sin(t), d = std::cos(0.7 * t),
                 e = std::sin(0.7 * t);
    const Field u = c * x() + s * y() - 0.013 * k, m = c * y() - s * x();
    const Field v = d * m + e * z() + 0.007 * k, w = d * z() - e * m;
    const Region block = solid(0.8 - u) & solid(0.8 + u) & solid(0.6 - v) & solid(0.6 + v) &
                         solid(0.5 - w) & solid(0.5 + w);
    const Region region = block - solid(0.09 - square(u + 0.3) - square(v)) -
                          solid(0.09 - square(u - 0.4) - square(v) - square(w - 0.5));
    const double volume = 1.6 * 1.2 - 0.09 * pi - 2 * pi / 3 * 0.027;
    const double area =
        2 * (1.6 * 1.2 + 1.6 + 1.2) - 2 * 0.09 * pi + 0.6 * pi - 0.09 * pi + 2 * pi * 0.09;
    const Errors error = errors(region, volume, area, 14, 6);
    EXPECT_LT(error.volume, 1e-7) << k;
    EXPECT_LT(error.area, 1e-5) << k;
    EXPECT_LT(error.report.divergence_defect, 5e-6) << k;
    EXPECT_LT(error.report.uncertified.measure, 1e-3) << k;
  }
}

TEST(FailureModes3D, ThinPlates) {
  for (const double width : {2e-3, 2e-6, 2e-10, 1e-10}) {
    const double w = width / 2;
    const Field across = (2 * x() - y() + 2 * z()) / 3;
    const Region plate =
        solid(1 - square(x()) - square(y()) - square(z())) & solid(w - across) & solid(w + across);
    const double volume = 2 * pi * (w - w * w * w / 3), area = 2 * pi * (1 - w * w) + 4 * pi * w;
    const Errors error = errors(plate, volume, area, 8, 10);
    // Of the thinnest plate the faces are rounded to multiples of 1e-17.
    EXPECT_LT(error.volume, 1e-12 + 1e-17 / width);
    EXPECT_LT(error.area, 1e-13);
  }
}

TEST(FailureModes3D, ShellsAsThinAsOneTenBillionth) {
  for (const double width : {1e-3, 1e-6, 1e-10}) {
    const auto ball = [](double radius) {
      return solid((radius * radius - square(x() - 0.1) - square(y() - 0.2) - square(z())) / 2);
    };
    const Region shell = ball(1) - ball(1 - width);
    const double within = (1 - width) * (1 - width);
    const Errors error = errors(shell, 4 * pi / 3 * width * (1 + (1 - width) + within),
                                4 * pi * (1 + within), 8, 10);
    // The square of the inner radius is rounded to 1e-16.
    EXPECT_LT(error.volume, 1e-11 + 1e-16 / width);
    EXPECT_LT(error.area, 1e-11);
    EXPECT_EQ(error.report.uncertified.boxes, 0);
  }
}

TEST(FailureModes3D, WorkOnACellEndsSoonAfterItsBudget) {
  // Two gyroids, a quartic and a torus in eight cells, far from resolved by them.
  const auto wave = [](const Field& a, const Field& b) { return sin(3 * a) * cos(3 * b); };
  const auto gyroid = [&](const Field& a) {
    return solid(0.1 + wave(a, y()) + wave(y(), z()) + wave(z(), a));
  };
  const Field ring = square(x()) + square(y());
  const Region region = ((gyroid(x()) ^ gyroid(x() + 0.3 * y())) |
                         solid(1 - square(square(x())) - 5 * square(square(z())) - square(y()))) -
                        solid(ring - square(ring + square(z()) + 0.1));
  QuadratureOptions options;
  for (const int budget : {100'000, 1'000'000}) {
    options.subdivision.max_work = budget;
    double most = 0;
    for (int cell = 0; cell < 8; ++cell) {
      const Grid all = grid(1.1, 2, 3);
      const Grid alone(all.cell(all.position(cell)), {1, 1, 1});
      const RegionEvaluator evaluator(region);
      tbb::global_control one_thread(tbb::global_control::max_allowed_parallelism, 1);
      const std::int64_t before = work_done;
      const DomainRule rule = make_domain_rule(evaluator, alone, options);
      most = std::max(most, static_cast<double>(work_done - before));
      EXPECT_GT(rule.report().uncertified.boxes, 0);
      EXPECT_GT(rule.report().uncertified.measure, 0);
    }
    EXPECT_LT(most, 3.0 * budget + 3e6) << budget;
  }
}

}  // namespace
