// Curves of the plane that touch: lines through the contact, and lines as near to it as the root of
// the rounding, meet both in one place.

#include <fmt/format.h>
#include <gmock/gmock.h>

#include "quadrature/domain_rule.hpp"
#include "tests/quadrature/regions.hpp"

using namespace rfm;
using namespace rfm::test;

namespace {

struct Case {
  const char* name;
  Region region;
  double area, perimeter;
};

// In [−1, 1]² the contacts are in nodes, on edges and in middles of cells, by the number of cells;
// in [−1.3, 1.3]² some are not.
void expect_whole_boundary(const Case& one) {
  for (const double half : {1.0, 1.3})
    for (int cells = 4; cells <= 33; ++cells)
      for (int points = 1; points <= 14; ++points) {
        QuadratureOptions options;
        options.inside_points = 2;
        options.cut_points = points;
        const DomainRule rule =
            make_domain_rule(RegionEvaluator(one.region), grid(half, cells), options);
        const QuadratureReport& report = rule.report();
        const std::string where = fmt::format("{}, {} cells in [-{}, {}]², {} points", one.name,
                                              cells, half, half, points);
        ASSERT_NEAR(rule.measure(), one.area,
                    3 * report.order_difference.volume + report.uncertified.measure + 1e-12)
            << where;
        ASSERT_NEAR(rule.boundary_measure(), one.perimeter,
                    3 * report.order_difference.boundary + report.uncertified.boundary + 1e-11)
            << where;
        if (cells >= 16 && points >= 8) {
          ASSERT_NEAR(rule.boundary_measure(), one.perimeter, 2e-8) << where;
          ASSERT_LT(report.order_difference.boundary / 3, 2e-7) << where;
        }
      }
}

TEST(TangentCurves, ADiskInADiskLeavesACrescentWithAllOfItsBoundary) {
  expect_whole_boundary({"crescent", disk(0, 0, 1) - disk(0.5, 0, 0.5), 0.75 * pi, 3 * pi});
}

TEST(TangentCurves, TheContactMayBeInGeneralPosition) {
  const double c = std::cos(0.4), s = std::sin(0.4);
  expect_whole_boundary({"turned crescent",
                         disk(0.01, 0.02, 0.9) - disk(0.01 + 0.4 * c, 0.02 + 0.4 * s, 0.5),
                         pi * (0.81 - 0.25), 2 * pi * 1.4});
}

TEST(TangentCurves, DisksThatKissKeepBothCircles) {
  expect_whole_boundary({"kissing", disk(-0.5, 0, 0.5) | disk(0.5, 0, 0.5), 0.5 * pi, 2 * pi});
}

TEST(TangentCurves, DisksThatMeetInAPointHaveNothingInCommon) {
  expect_whole_boundary({"point", disk(-0.5, 0, 0.5) & disk(0.5, 0, 0.5), 0, 0});
}

TEST(TangentCurves, FourCirclesMayTouchInOnePoint) {
  expect_whole_boundary(
      {"four", (disk(0, 0, 1) - disk(0.25, 0, 0.75)) | (disk(0.5, 0, 0.5) - disk(0.75, 0, 0.25)),
       pi * (1 - 0.5625 + 0.25 - 0.0625), 5 * pi});
}

TEST(TangentCurves, WhatIsThinnerThanRoundingTellsIsReported) {
  // Of a strip of width 1e-14 lines take both sides for one; the boundary is missing, and is told.
  const Field across = std::cos(0.3) * y() - std::sin(0.3) * x();
  const Region strip = disk(0, 0, 1) & region_of(5e-15 - across, 2) & region_of(5e-15 + across, 2);
  const DomainRule rule = make_domain_rule(RegionEvaluator(strip), grid(1.3, 16));
  EXPECT_GT(rule.report().uncertified.boxes, 0);
  // The square of a line has nothing between its sides, whatever rounding makes of them.
  const Field line = y() - 0.1 - 0.3 * x();
  const Region slit = disk(0, 0, 1) & (region_of(line, 2) | region_of(-2 * line, 2));
  EXPECT_EQ(make_domain_rule(RegionEvaluator(slit), grid(1.3, 16)).report().uncertified.boxes, 0);
}

}  // namespace
