#include "problems/worst_cells.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>

#include "core/primitives.hpp"

using namespace rfm;

namespace {

DomainRule rule_for(const Region& region, int cells) {
  QuadratureOptions options;
  options.cut_points = 3;
  return make_domain_rule(RegionEvaluator(region), Grid({2, {-1, -1}, {1, 1}}, {cells, cells, 1}),
                          options);
}

TEST(WorstCells, AreThoseWithCurvedParts) {
  // A hole in one cell, and two larger ones across several; the box around them is exact.
  const Region outer = box({-0.9, -0.9}, {0.9, 0.9});
  const DomainRule one = rule_for(outer - circle({0.51, 0.49}, 0.08), 10);
  const auto only = worst_cells(one, 4);
  ASSERT_EQ(only.size(), 1u);
  EXPECT_EQ(only[0].position, (std::array{7, 7, 0}));
  EXPECT_NEAR(only[0].center[0], 0.5, 1e-15);
  EXPECT_NEAR(only[0].center[1], 0.5, 1e-15);
  // The straight sides differ by rounding.
  EXPECT_NEAR(only[0].report.order_difference.volume, one.report().order_difference.volume, 1e-15);
  EXPECT_GT(only[0].divergence_defect, 0);

  const DomainRule two =
      rule_for(outer - circle({-0.35, -0.3}, 0.4) - circle({0.46, 0.37}, 0.3), 10);
  const auto worst = worst_cells(two, 4);
  ASSERT_EQ(worst.size(), 4u);
  double largest = 0;
  for (const CellReport& cell : two.report().cells)
    largest = std::max(largest, cell.order_difference.boundary);
  EXPECT_EQ(worst[0].report.order_difference.boundary, largest);
  for (std::size_t i = 1; i < worst.size(); ++i)
    EXPECT_LE(worst[i].report.order_difference.boundary,
              2 * worst[i - 1].report.order_difference.boundary);
}

TEST(WorstCells, DoNotExistWhereAllIsExact) {
  EXPECT_TRUE(worst_cells(rule_for(box({-0.9, -0.8}, {0.7, 0.9}), 7), 5).empty());
}

TEST(WorstCells, AreWrittenWithAsManyCoordinatesAsThereAre) {
  WorstCell cell;
  cell.position = {3, 4, 0};
  cell.center = {0.25, -1.5, 0};
  cell.report.order_difference = {1e-7, 2e-6};
  cell.divergence_defect = 3e-8;
  EXPECT_EQ(
      as_text(cell, 2),
      "cell (3, 4) around (0.25, -1.5): orders differ by 1.0e-07, on the boundary by 2.0e-06; "
      "divergence theorem 3.0e-08");
  cell.report.uncertified = {2, 1e-5, 1e-3};
  EXPECT_THAT(as_text(cell, 2), testing::EndsWith("; best effort in 1.0e-05"));
  const auto json = as_json({cell}, 2);
  EXPECT_EQ(json[0]["cell"], (std::vector{3, 4}));
  EXPECT_EQ(json[0]["center"], (std::vector{0.25, -1.5}));
  EXPECT_EQ(json[0]["order_difference"]["boundary_total"], 2e-6);
  EXPECT_EQ(json[0]["uncertified_boundary"], 1e-3);
}

}  // namespace
