// Rules are the same bit by bit for every number of threads.

#include <gmock/gmock.h>
#include <tbb/global_control.h>

#include <algorithm>

#include "quadrature/cell_classification.hpp"
#include "quadrature/divergence_defects.hpp"
#include "quadrature/integrate.hpp"
#include "tests/quadrature/standard_regions.hpp"

using namespace rfm;
using namespace rfm::test;

namespace {

DomainRule rule_with(int threads, const StandardRegion& body) {
  tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
  // In the plane enough for a classification by all threads.
  const int cells = body.box.dimension == 2 ? 80 : 9;
  QuadratureOptions options;
  options.inside_points = options.cut_points = 4;
  return make_domain_rule(RegionEvaluator(body.region), Grid(body.box, {cells, cells, cells}),
                          options);
}

void expect_equal(const SurfaceRule& a, const SurfaceRule& b) {
  EXPECT_EQ(a.points.coordinates, b.points.coordinates);
  EXPECT_EQ(a.points.normals, b.points.normals);
  EXPECT_EQ(a.points.weights, b.points.weights);
  EXPECT_EQ(a.points.numbers, b.points.numbers);
  EXPECT_EQ(a.cells, b.cells);
  EXPECT_EQ(a.begin, b.begin);
}

double integral_with(int threads, const DomainRule& rule) {
  tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
  return integrate(rule, [](const QuadratureBlock& block, double* values) {
    for (int k = 0; k < block.count; ++k)
      values[k] = std::exp(block.coordinates[0][k]) * std::cos(block.coordinates[1][k]);
  });
}

class Threads : public testing::TestWithParam<StandardRegion> {};
INSTANTIATE_TEST_SUITE_P(Plane, Threads, testing::ValuesIn(standard_regions_2d()));
INSTANTIATE_TEST_SUITE_P(Space, Threads,
                         testing::Values(standard_regions_3d()[1], standard_regions_3d()[3],
                                         standard_regions_3d()[4], standard_regions_3d()[5]));

TEST_P(Threads, DoNotChangeASingleBit) {
  const DomainRule one = rule_with(1, GetParam());
  const double integral = integral_with(1, one);
  for (const int threads : {2, 3, 8}) {
    const DomainRule rule = rule_with(threads, GetParam());
    EXPECT_EQ(one.inside_cells(), rule.inside_cells());
    EXPECT_EQ(one.cut_cells(), rule.cut_cells());
    EXPECT_EQ(one.cut_points().coordinates, rule.cut_points().coordinates);
    EXPECT_EQ(one.cut_points().weights, rule.cut_points().weights);
    expect_equal(one.boundary(), rule.boundary());
    EXPECT_EQ(one.report().divergence_defect, rule.report().divergence_defect);
    EXPECT_EQ(one.report().uncertified.measure, rule.report().uncertified.measure);
    EXPECT_EQ(one.report().order_difference.boundary, rule.report().order_difference.boundary);
    EXPECT_EQ(divergence_defects(one), divergence_defects(rule));
    EXPECT_EQ(integral, integral_with(threads, rule)) << threads;
  }
}

TEST(Threads, DoNotChangeTheClassificationOfLargeGrids) {
  for (const StandardRegion& body : standard_regions_3d()) {
    const RegionEvaluator region(body.region);
    const auto with_threads = [&](int threads) {
      tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
      return classify_cells(region, Grid(body.box, {18, 19, 20}));
    };
    const CellClassification one = with_threads(1);
    for (const int threads : {2, 3, 8}) {
      const CellClassification other = with_threads(threads);
      EXPECT_EQ(one.states, other.states) << body;
      ASSERT_EQ(one.cut_cells, other.cut_cells) << body;
      for (int i = 0; i < static_cast<int>(one.cut_cells.size()); ++i)
        EXPECT_TRUE(std::ranges::equal(one.primitives(i), other.primitives(i))) << body;
    }
  }
}

}  // namespace
