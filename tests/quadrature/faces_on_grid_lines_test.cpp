#include <gmock/gmock.h>

#include "core/primitives.hpp"
#include "quadrature/domain_rule.hpp"
#include "tests/quadrature/regions.hpp"

using namespace rfm;
using namespace rfm::test;

namespace {

DomainRule rule_for(const Region& region, const Grid& grid) {
  QuadratureOptions options;
  options.inside_points = options.cut_points = 3;
  return make_domain_rule(RegionEvaluator(region), grid, options);
}

// [−a, a]² from four half-planes, numbered right, left, top, bottom.
Region box(double a) {
  return half_plane(-1, 0, a) & half_plane(1, 0, a) & half_plane(0, -1, a) & half_plane(0, 1, a);
}

TEST(FacesOnGridLines, AreCountedOnce) {
  for (const int cells : {4, 8, 16, 32}) {
    const DomainRule rule = rule_for(box(1), grid(2, cells));
    EXPECT_NEAR(rule.measure(), 4, 1e-15);
    for (int side = 0; side < 4; ++side) EXPECT_NEAR(rule.boundary_measure(side), 2, 1e-15);
    EXPECT_EQ(rule.report().inside_cells, cells * cells / 4);
    EXPECT_EQ(rule.report().cut_cells, 0);
    EXPECT_LT(rule.report().divergence_defect, 1e-14);
  }
}

TEST(FacesOnGridLines, OfParabolasAreCertified) {
  // 1 − y² vanishes identically on the side y = −1 of a cell.
  const Region region = region_of(1 - square(x()), 2) & region_of(1 - square(y()), 2);
  for (const double half : {1.0, 2.0}) {
    const DomainRule rule = rule_for(region, grid(half, 4));
    EXPECT_NEAR(rule.measure(), 4, 1e-14);
    EXPECT_NEAR(rule.boundary_measure(0), 4, 1e-14);
    EXPECT_NEAR(rule.boundary_measure(1), 4, 1e-14);
    EXPECT_EQ(rule.report().uncertified.boxes, 0);
  }
}

TEST(FacesOnGridLines, BelongToTheCellsInside) {
  const DomainRule rule = rule_for(box(1), grid(2, 8));
  for (const int cell : rule.boundary().cells) EXPECT_EQ(rule.state(cell), CellState::inside);
  EXPECT_EQ(rule.boundary().cells.size(), 12u);
}

TEST(FacesOnGridLines, OnTheSidesOfTheGridAreSeen) {
  for (const int cells : {1, 2, 5, 8}) {
    const DomainRule rule = rule_for(box(1), grid(1, cells));
    EXPECT_NEAR(rule.measure(), 4, 1e-14);
    for (int side = 0; side < 4; ++side) EXPECT_NEAR(rule.boundary_measure(side), 2, 1e-14);
    EXPECT_EQ(rule.report().inside_cells, cells * cells);
    const SurfacePoints& points = rule.boundary().points;
    for (int i = 0; i < points.size(); ++i)
      EXPECT_TRUE(rule.grid().box().contains(points.point(i)));
  }
}

TEST(FacesOnGridLines, MissedByRoundingAreSeenToo) {
  // The side of the grid is short of the face by one unit in the last place, and beyond it.
  for (const double half : {std::nextafter(0.3, 0.0), std::nextafter(0.3, 1.0)}) {
    const DomainRule rule = rule_for(box(0.3), grid(half, 4));
    for (int side = 0; side < 4; ++side) EXPECT_NEAR(rule.boundary_measure(side), 0.6, 1e-14);
    EXPECT_NEAR(rule.measure(), 0.36, 1e-14);
  }
}

TEST(FacesOnGridLines, ACircleInTheBoundingBoxKeepsItsPerimeter) {
  const DomainRule rule = rule_for(disk(0, 0, 1), grid(1, 64));
  EXPECT_NEAR(rule.boundary_measure(), 2 * pi, 1e-9);
  EXPECT_NEAR(rule.measure(), pi, 1e-9);
}

TEST(FacesOnGridLines, A1e14OffThemAreCountedOnce) {
  for (const double off : {-1e-14, 1e-14})
    for (const int cells : {4, 8, 16}) {
      const DomainRule rule = rule_for(box(1 + off), grid(2, cells));
      EXPECT_NEAR(rule.measure(), 4, 1e-13);
      for (int side = 0; side < 4; ++side) EXPECT_NEAR(rule.boundary_measure(side), 2, 1e-13);
      EXPECT_LT(rule.report().divergence_defect, 1e-13);
    }
}

TEST(FacesOnGridLines, BetweenTwoPartsOfTheRegionLeaveNoCrack) {
  // [−1, 0] × [−1, 1] joined to [0, 1] × [−1, 1]: the line x = 0 is no boundary.
  const Region joined = box(1) & (half_plane(1, 0, 0) | half_plane(-1, 0, 0));
  for (const int cells : {4, 5}) {
    const DomainRule rule = rule_for(joined, grid(2, cells));
    EXPECT_NEAR(rule.measure(), 4, 1e-14);
    EXPECT_NEAR(rule.boundary_measure(), 8, 1e-14);
  }
}

// The sides of a are none of the boundary where b begins, wherever the grid has its lines.
TEST(FacesOnGridLines, OfFlushShapesThatLookAtEachOtherLeaveNoCrack) {
  const Region a = rfm::box({-1, -1}, {1, 1}), b = rfm::box({1, -1}, {1.5, 1}),
               hole = rfm::box({-0.8, -0.3}, {-0.2, 0.3}),
               plate = rfm::box({-1.9, -1.9}, {1.9, 1.9});
  const struct {
    Region region;
    double area, perimeter;
  } cases[] = {{a ^ b, 5, 9},
               {(a & b) | hole, 0.36, 2.4},
               {plate - (a ^ b), 14.44 - 5, 15.2 + 9},
               {plate - (a & b), 14.44, 15.2},
               {(a | b) - b, 4, 8},
               {a ^ (a | b), 1, 5},
               {a - !b, 0, 0}};
  for (const auto& [region, area, perimeter] : cases)
    for (const int cells : {7, 8, 12, 16}) {
      const DomainRule rule = rule_for(region, grid(2, cells));
      EXPECT_NEAR(rule.measure(), area, 1e-12) << cells;
      EXPECT_NEAR(rule.boundary_measure(), perimeter, 1e-12) << cells;
    }
  const Region body = rfm::box({-1, -1, -1}, {1, 1, 1}, 3),
               flush = rfm::box({1, -1, -1}, {1.5, 1, 1}, 3);
  for (const int cells : {4, 7, 8}) {
    EXPECT_NEAR(rule_for(body ^ flush, grid(2, cells, 3)).boundary_measure(), 28, 1e-12) << cells;
    EXPECT_NEAR(rule_for(body - (body ^ flush), grid(2, cells, 3)).boundary_measure(), 0, 1e-12);
  }
  // A slit as thin as one ten billionth is no crack.
  const Region slit = a | rfm::box({1 + 1e-10, -1}, {1.5, 1});
  EXPECT_NEAR(rule_for(slit, grid(2, 8)).boundary_measure(), 13, 1e-9);
}

TEST(FacesOnGridLines, OfHolesAreCountedOnce) {
  for (const int cells : {8, 16}) {
    const DomainRule rule = rule_for(box(1) - box(0.5), grid(1, cells));
    EXPECT_NEAR(rule.measure(), 3, 1e-14);
    EXPECT_NEAR(rule.boundary_measure(), 12, 1e-14);
    EXPECT_LT(rule.report().divergence_defect, 1e-14);
  }
}

TEST(FacesOnGridLines, TurnedBy90DegreesInFloatingPointAreCountedOnce) {
  // cos 90° is 6e-17: every side of the square lies on a grid line but for that, and is on either
  // side of it by chance.
  for (int turns = 0; turns < 4; ++turns) {
    const double c = std::cos(turns * pi / 2), s = std::sin(turns * pi / 2);
    const auto side = [&](double nx, double ny) {
      return region_of(0.5 - nx * (x() - 0.25) - ny * (y() + 0.125), 2);
    };
    const Region square = side(c, s) & side(-s, c) & side(-c, -s) & side(s, -c);
    const DomainRule rule = make_domain_rule(RegionEvaluator(square), grid(1.5, 24));
    EXPECT_NEAR(rule.measure(), 1, 1e-14) << turns;
    EXPECT_NEAR(rule.boundary_measure(), 4, 1e-13) << turns;
    EXPECT_EQ(rule.report().uncertified.boxes, 0) << turns;
  }
}

TEST(FacesOnGridLines, ACircleThatTouchesThemKeepsItsPerimeter) {
  // Within 1e-8 of the place where it touches, rounding says on which side of the line it is.
  for (const int cells : {12, 24, 48}) {
    QuadratureOptions options;
    options.cut_points = 14;
    const DomainRule rule =
        make_domain_rule(RegionEvaluator(disk(0, 0, 1.25)), grid(1.5, cells), options);
    EXPECT_NEAR(rule.measure(), 1.5625 * pi, 1e-13) << cells;
    EXPECT_LE(std::fabs(rule.boundary_measure() - 2.5 * pi),
              rule.report().order_difference.boundary + 1e-12)
        << cells;
    EXPECT_LT(rule.report().divergence_defect, cells == 12 ? 1e-8 : 1e-10) << cells;
  }
}

TEST(FacesOnGridLines, CirclesThroughNodesKeepTheirPerimeter) {
  // Radius 5/4: through (1, 3/4) and its mirror images, nodes of all of these grids.
  for (const int cells : {12, 24, 48}) {
    QuadratureOptions options;
    options.cut_points = 14;
    const Region segment = disk(0, 0, 1.25) & half_plane(-1, 0, 1) & half_plane(0, 1, 0.75);
    const DomainRule rule = make_domain_rule(RegionEvaluator(segment), grid(1.5, cells), options);
    // The disk without what lies beyond the chords x = 1 and y = −3/4, which meet on the circle.
    const auto cap = [](double d) {
      return 1.5625 * std::acos(d / 1.25) - d * std::sqrt(1.5625 - d * d);
    };
    EXPECT_NEAR(rule.measure(), 1.5625 * pi - cap(1) - cap(0.75), 1e-13) << cells;
    const double arc = 1.25 * 2 * (pi - std::acos(0.8) - std::acos(0.6));
    EXPECT_NEAR(rule.boundary_measure(0), arc, 1e-11 + rule.report().order_difference.boundary);
    EXPECT_NEAR(rule.boundary_measure(1), 1.5, 1e-13) << cells;
    EXPECT_NEAR(rule.boundary_measure(2), 2, 1e-13) << cells;
    EXPECT_LT(rule.report().divergence_defect, cells == 12 ? 1e-8 : 1e-10) << cells;
  }
}

TEST(FacesOnGridLines, CornersOnNodesAndOnLinesAreCountedOnce) {
  // A square on its corner: all four corners are nodes, the sides run along diagonals of cells; by
  // 1e-14 larger and smaller, and with the corners on lines only.
  for (const double off : {0.0, 1e-14, -1e-14, 0.03125})
    for (const int cells : {4, 8, 16}) {
      const double a = 1 + off;
      const Region square =
          half_plane(1, 1, a) & half_plane(-1, 1, a) & half_plane(1, -1, a) & half_plane(-1, -1, a);
      const DomainRule rule = rule_for(square, grid(2, cells));
      EXPECT_NEAR(rule.measure(), 2 * a * a, 1e-13) << off << " " << cells;
      for (int side = 0; side < 4; ++side)
        EXPECT_NEAR(rule.boundary_measure(side), std::sqrt(2.0) * a, 1e-13) << off << " " << cells;
      EXPECT_LT(rule.report().divergence_defect, 1e-13) << off << " " << cells;
      EXPECT_EQ(rule.report().uncertified.boxes, 0) << off << " " << cells;
    }
}

TEST(FacesOnGridPlanes, A1e14OffThemAreCountedOnce) {
  const auto solid = [](const Field& level) { return region_of(level, 3); };
  for (const double off : {0.0, 1e-14, -1e-14})
    for (const int cells : {4, 8}) {
      const double a = 1 + off;
      const Region cube = solid(a - x()) & solid(a + x()) & solid(a - y()) & solid(a + y()) &
                          solid(a - z()) & solid(a + z());
      const DomainRule rule = rule_for(cube, grid(2, cells, 3));
      EXPECT_NEAR(rule.measure(), 8, 1e-12) << off << " " << cells;
      for (int side = 0; side < 6; ++side)
        EXPECT_NEAR(rule.boundary_measure(side), 4, 1e-12) << off << " " << cells;
      EXPECT_LT(rule.report().divergence_defect, 1e-12) << off << " " << cells;
    }
}

TEST(FacesOnGridPlanes, VerticesOnNodesAndEdgesOnLinesAreCountedOnce) {
  // A tetrahedron in a cube: vertices on nodes, edges along diagonals of the faces of cells.
  const auto solid = [](const Field& level) { return region_of(level, 3); };
  for (const double off : {0.0, 1e-14, -1e-14})
    for (const int cells : {2, 4, 5, 8}) {
      const double a = 1 + off;
      const Region body = solid(a + x() + y() + z()) & solid(a + x() - y() - z()) &
                          solid(a - x() + y() - z()) & solid(a - x() - y() + z());
      const DomainRule rule = rule_for(body, grid(1 + 1e-13, cells, 3));
      EXPECT_NEAR(rule.measure(), 8.0 / 3 * a * a * a, 1e-12) << off << " " << cells;
      for (int side = 0; side < 4; ++side)
        EXPECT_NEAR(rule.boundary_measure(side), 2 * std::sqrt(3.0), 1e-12) << off << " " << cells;
      EXPECT_LT(rule.report().divergence_defect, 1e-12) << off << " " << cells;
    }
}

}  // namespace
