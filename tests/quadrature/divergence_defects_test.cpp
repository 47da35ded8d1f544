#include "quadrature/divergence_defects.hpp"

#include <gmock/gmock.h>

#include <map>

#include "tests/quadrature/standard_regions.hpp"

using namespace rfm;
using namespace rfm::test;

namespace {

DomainRule rule_for(const Region& region, const Grid& grid, int points) {
  QuadratureOptions options;
  options.inside_points = options.cut_points = points;
  return make_domain_rule(RegionEvaluator(region), grid, options);
}

double largest(const std::vector<double>& values) {
  return values.empty() ? 0 : *std::ranges::max_element(values);
}

TEST(DivergenceDefects, VanishOnPolytopesInEveryCell) {
  // Multilinear functions on slanted faces: degree 3 in the plane, 5 in space.
  for (const int cells : {1, 4, 7}) {
    const DomainRule plane = rule_for(star(0.45, 0.21), grid(1.7, cells), 2);
    const std::vector<double> in_plane = divergence_defects(plane);
    EXPECT_EQ(in_plane.size(), plane.report().cells.size());
    EXPECT_LT(largest(in_plane), 1e-14) << cells;
    EXPECT_LT(largest(divergence_defects(rule_for(rotated_cube(0.85), grid(1.7, cells, 3), 3))),
              1e-13)
        << cells;
  }
  const Region segment = region_of(0.9 - x(), 1) & region_of(0.8 + x(), 1);
  EXPECT_LT(largest(divergence_defects(rule_for(segment, grid(1.1, 5, 1), 2))), 1e-15);
}

TEST(DivergenceDefects, VanishWhereFacesLieOnLinesOfTheGrid) {
  // The boundary is owned by cells inside that no report lists.
  const Region box =
      half_plane(-1, 0, 1) & half_plane(1, 0, 1) & half_plane(0, -1, 1) & half_plane(0, 1, 1);
  EXPECT_LT(largest(divergence_defects(rule_for(box, grid(2, 8), 2))), 1e-15);
  EXPECT_LT(largest(divergence_defects(rule_for(box, grid(1, 8), 2))), 1e-15);
}

TEST(DivergenceDefects, OfCurvedBodiesFallWithTheOrderToRounding) {
  for (const StandardRegion& body : {standard_regions_2d()[2], standard_regions_3d()[3]}) {
    const int cells = body.box.dimension == 2 ? 16 : 8;
    double previous = INFINITY;
    for (const int points : {2, 4, 6, 8, 12}) {
      const double defect = largest(
          divergence_defects(rule_for(body.region, Grid(body.box, {cells, cells, cells}), points)));
      EXPECT_LT(defect, std::max(0.1 * previous, 1e-15)) << body << " " << points;
      if (points < 6) {
        EXPECT_GT(defect, 1e-12) << body << " " << points;
      }
      previous = defect;
    }
    EXPECT_LT(previous, 1e-12) << body;
  }
}

TEST(DivergenceDefects, PointAtTheCellThatIsWrong) {
  // A small hole is far below what one point per cell resolves; the polygon around it is exact.
  const Point hole{0.3, -0.2};
  const Region region = turned_square(0.9, 0.3) - disk(hole[0], hole[1], 0.07);
  const DomainRule rule = rule_for(region, grid(1.7, 16), 2);
  const std::vector<double> defects = divergence_defects(rule);
  ASSERT_GT(largest(defects), 1e-6);
  for (std::size_t i = 0; i < defects.size(); ++i) {
    const Point center =
        rule.grid().cell(rule.grid().position(rule.report().cells[i].cell)).center();
    const double away = std::max(std::fabs(center[0] - hole[0]), std::fabs(center[1] - hole[1]));
    if (away > 0.07 + 2.5 * rule.grid().spacing(0)) {
      EXPECT_LT(defects[i], 1e-15);
    }
  }
}

TEST(DivergenceDefects, AreOfTheSizeOfTheSideThatIsMissing) {
  // A face on a line of the grid that only the neighbouring cell could have found: what the report
  // of a rule on half of the region would look like. The right half of the square, cut off by the
  // side of the grid at x = 0: the region reaches beyond the grid and its boundary is open there.
  const Region region = turned_square(0.9, 0.3);
  const Grid half({2, {0, -1.7}, {1.7, 1.7}}, {4, 8, 1});
  const DomainRule rule = rule_for(region, half, 2);
  const std::vector<double> defects = divergence_defects(rule);
  EXPECT_GT(rule.report().divergence_defect, 0.1);
  for (std::size_t i = 0; i < defects.size(); ++i) {
    const std::array<int, 3> position = half.position(rule.report().cells[i].cell);
    // Cells at the side of the grid reach beyond it by 1e-12.
    if (position[0] > 0) {
      EXPECT_LT(defects[i], 1e-11);
    }
  }
  // Each node on the cut misses the length of one cell, weighted: h · h / 2.
  EXPECT_NEAR(largest(defects), 0.425 * 0.425 / 2, 1e-3);
}

TEST(DivergenceDefects, ReportsOfCellsAddUpToTheReportOfTheRule) {
  const auto r2 = square(x()) + square(y());
  const Region cone = solid(z() - sqrt(r2)) & solid(1 - z());
  const DomainRule rule = rule_for(cone, grid(1.3, 7, 3), 4);
  const QuadratureReport& report = rule.report();
  ASSERT_GT(report.uncertified.boxes, 0);
  Uncertified uncertified;
  CellMeasure difference;
  int previous = -1;
  for (const CellReport& cell : report.cells) {
    EXPECT_GT(cell.cell, previous);
    previous = cell.cell;
    uncertified += cell.uncertified;
    difference.volume += cell.order_difference.volume;
    difference.boundary += cell.order_difference.boundary;
    // The apex is all that is not certified.
    if (cell.uncertified.boxes > 0) {
      EXPECT_TRUE(rule.grid().cell(rule.grid().position(cell.cell)).contains({0, 0, 0}));
    }
  }
  EXPECT_EQ(uncertified.boxes, report.uncertified.boxes);
  EXPECT_EQ(uncertified.measure, report.uncertified.measure);
  EXPECT_EQ(difference.volume, report.order_difference.volume);
  EXPECT_EQ(difference.boundary, report.order_difference.boundary);
}

}  // namespace
