// Errors of volume and boundary fall like h^(2q) for q Gauss points, no slower and no faster, on
// bodies without corners and with corners, edges and vertices inside of cells.

#include <gmock/gmock.h>

#include "quadrature/domain_rule.hpp"
#include "tests/quadrature/standard_regions.hpp"

using namespace rfm;
using namespace rfm::test;

namespace {

Region ball(double a, double b, double c, double r) {
  return solid(r * r - square(x() - a) - square(y() - b) - square(z() - c));
}

// The lens common to two circles of radius 1 and r at distance d.
struct Lens {
  double area, arc, other_arc;
};
Lens lens(double r, double d) {
  const double alpha = std::acos((d * d + 1 - r * r) / (2 * d));
  const double beta = std::acos((d * d + r * r - 1) / (2 * d * r));
  return {alpha - std::sin(2 * alpha) / 2 + r * r * (beta - std::sin(2 * beta) / 2), 2 * alpha,
          2 * r * beta};
}

StandardRegion disk_without_disk() {
  const Lens cut = lens(0.7, std::hypot(0.6, 0.3));
  return {"disk without disk", disk(0, 0, 1) - disk(0.6, 0.3, 0.7), cube_box(1.7, 2), pi - cut.area,
          2 * pi - cut.arc + cut.other_arc};
}

// A quarter of a disk, turned: one corner between lines, two between a line and the circle.
StandardRegion turned_quarter() {
  const double c = std::cos(0.4), s = std::sin(0.4);
  return {"quarter of a disk",
          disk(-0.3, -0.2, 1.2) & half_plane(c, s, 0.3 * c + 0.2 * s) &
              half_plane(-s, c, -0.3 * s + 0.2 * c),
          cube_box(1.7, 2), 0.36 * pi, 0.6 * pi + 2.4};
}

// An eighth of a ball, turned: four vertices, edges between planes and between plane and sphere.
StandardRegion turned_eighth() {
  const auto rows = standard_rotation();
  Region body = ball(-0.4, -0.5, -0.3, 1.3);
  for (const Point& row : rows)
    body = body & solid(row[0] * (x() + 0.4) + row[1] * (y() + 0.5) + row[2] * (z() + 0.3));
  return {"eighth of a ball", body, cube_box(1.7, 3), pi / 6 * 2.197,
          pi / 2 * 1.69 + 0.75 * pi * 1.69};
}

// Two caps of spheres that meet in a circle, aslant.
StandardRegion lens_of_balls() {
  const double d = std::sqrt(0.36 + 0.09 + 0.04), r = 0.8;
  const double x = (d * d + 1 - r * r) / (2 * d);
  const double h = 1 - x, g = r - (d - x);  // the heights of the caps
  return {"lens of two balls", ball(0, 0, 0, 1) & ball(0.6, 0.3, 0.2, r), cube_box(1.7, 3),
          pi * h * h * (3 - h) / 3 + pi * g * g * (3 * r - g) / 3, 2 * pi * h + 2 * pi * r * g};
}

StandardRegion turned_cylinder() {
  const auto rows = standard_rotation();
  const auto along = [&](int i) { return rows[i][0] * x() + rows[i][1] * y() + rows[i][2] * z(); };
  return {"turned cylinder",
          solid(0.81 - square(along(0) - 0.05) - square(along(1))) & solid(0.7 - along(2)) &
              solid(0.6 + along(2)),
          cube_box(1.7, 3), 0.81 * pi * 1.3, 2 * 0.81 * pi + 1.8 * pi * 1.3};
}

struct Errors {
  double measure = 0, boundary = 0;
};

// Geometric means over positions of the grid: the error of one grid jumps with the places of cuts.
Errors mean_errors(const StandardRegion& body, int cells, int points, int positions) {
  const RegionEvaluator region(body.region);
  QuadratureOptions options;
  options.inside_points = options.cut_points = points;
  options.compare_orders = false;
  Errors logarithms;
  for (int k = 0; k < positions; ++k) {
    Box box = body.box;
    const double spacing = box.length(0) / cells;
    for (int axis = 0; axis < box.dimension; ++axis) {
      // A shift between 0 and a cell that does not repeat.
      const double shift = spacing * std::fmod((k + 0.5) * (axis + 1) * 0.6180339887, 1.0);
      box.low[axis] -= shift;
      box.high[axis] += spacing - shift;
    }
    const DomainRule rule =
        make_domain_rule(region, Grid(box, {cells + 1, cells + 1, cells + 1}), options);
    logarithms.measure += std::log(std::fabs(rule.measure() / body.measure - 1) + 1e-17);
    logarithms.boundary += std::log(std::fabs(rule.boundary_measure() / body.boundary - 1) + 1e-17);
  }
  return {std::exp(logarithms.measure / positions), std::exp(logarithms.boundary / positions)};
}

struct Study {
  StandardRegion body;
  /// Cells a side: curvature is resolved by the coarse grid, rounding does not show on the fine
  /// one.
  int coarse, fine;
  int positions;
};
std::ostream& operator<<(std::ostream& out, const Study& study) { return out << study.body; }

class OrderOfConvergence : public testing::TestWithParam<Study> {};
INSTANTIATE_TEST_SUITE_P(Plane, OrderOfConvergence,
                         testing::Values(Study{standard_regions_2d()[0], 12, 48, 48},
                                         Study{standard_regions_2d()[1], 48, 192, 48},
                                         Study{disk_without_disk(), 24, 96, 96},
                                         Study{turned_quarter(), 12, 48, 48}));
INSTANTIATE_TEST_SUITE_P(Space, OrderOfConvergence,
                         testing::Values(Study{standard_regions_3d()[0], 10, 30, 8},
                                         Study{standard_regions_3d()[1], 18, 40, 3},
                                         Study{turned_eighth(), 10, 30, 24},
                                         Study{turned_cylinder(), 10, 30, 12}));

TEST_P(OrderOfConvergence, IsTwiceTheNumberOfPoints) {
  const auto& [body, coarse, fine, positions] = GetParam();
  for (const int points : {2, 3, 4}) {
    const Errors before = mean_errors(body, coarse, points, positions);
    const Errors after = mean_errors(body, fine, points, positions);
    const double ratio = std::log(static_cast<double>(fine) / coarse);
    const double measure = std::log(before.measure / after.measure) / ratio;
    const double boundary = std::log(before.boundary / after.boundary) / ratio;
    EXPECT_NEAR(measure, 2 * points, 0.75) << points;
    EXPECT_NEAR(boundary, 2 * points, 0.75) << points;
  }
}

TEST(OrderOfConvergence, IsLessOnABoundaryAlmostParallelToPlanesOfTheGrid) {
  // At the distance δ from such a plane, a surface of curvature 1/R meets it in a circle of radius
  // √(2Rδ), the smallest of which remain as small as cells. The cells on both sides are wrong by
  // opposite amounts, unless an edge lies between; the volume there is small.
  const StandardRegion body = lens_of_balls();
  for (const int points : {2, 3, 4}) {
    const Errors before = mean_errors(body, 12, points, 16),
                 after = mean_errors(body, 36, points, 16);
    const double measure = std::log(before.measure / after.measure) / std::log(3.0);
    const double boundary = std::log(before.boundary / after.boundary) / std::log(3.0);
    EXPECT_NEAR(measure, 2 * points, 0.75) << points;
    EXPECT_GT(boundary, points + 1) << points;
    EXPECT_LT(boundary, 2 * points + 0.75) << points;
  }
}

}  // namespace
