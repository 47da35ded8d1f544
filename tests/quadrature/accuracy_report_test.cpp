// What a rule says of its own accuracy: more than its errors, and not by orders of magnitude where
// it is exact.

#include <gmock/gmock.h>

#include "quadrature/domain_rule.hpp"
#include "tests/quadrature/standard_regions.hpp"

using namespace rfm;
using namespace rfm::test;

namespace {

DomainRule rule_for(const Region& region, const Grid& grid, int points) {
  QuadratureOptions options;
  options.inside_points = options.cut_points = points;
  return make_domain_rule(RegionEvaluator(region), grid, options);
}

std::vector<StandardRegion> regions_of_known_measure() {
  std::vector<StandardRegion> known;
  for (const auto& regions : {standard_regions_2d(), standard_regions_3d()})
    for (const StandardRegion& region : regions)
      if (!std::isnan(region.measure)) known.push_back(region);
  return known;
}

TEST(AccuracyReport, TheDifferenceOfTwoOrdersBoundsTheErrors) {
  for (const StandardRegion& body : regions_of_known_measure())
    for (const int points : {2, 4}) {
      const DomainRule rule = rule_for(body.region, Grid(body.box, {8, 8, 8}), points);
      const QuadratureReport& report = rule.report();
      const double rounding = 1e-13 * body.boundary;
      EXPECT_LE(std::fabs(rule.measure() - body.measure), report.order_difference.volume + rounding)
          << body.name << " " << points;
      EXPECT_LE(std::fabs(rule.boundary_measure() - body.boundary),
                report.order_difference.boundary + rounding)
          << body.name << " " << points;
    }
}

TEST(AccuracyReport, TheDifferenceVanishesOnPolygonsAndFallsWithTheOrderElsewhere) {
  const StandardRegion disk = standard_regions_2d()[0];
  double previous = 3;  // three differences are announced
  for (const int points : {2, 4, 6, 8}) {
    const QuadratureReport report =
        rule_for(disk.region, Grid(disk.box, {8, 8, 1}), points).report();
    EXPECT_LT(report.order_difference.volume, 0.05 * previous) << points;
    EXPECT_GT(report.order_difference.volume, 0) << points;
    previous = report.order_difference.volume;
  }
  const DomainRule star_rule = rule_for(star(0.45, 0.21), grid(1.7, 8), 3);
  EXPECT_LT(star_rule.report().order_difference.volume, 1e-14);
  EXPECT_LT(star_rule.report().order_difference.boundary, 1e-13);
}

TEST(AccuracyReport, SaysNothingOfOrdersUnlessAsked) {
  QuadratureOptions options;
  options.compare_orders = false;
  const DomainRule rule = make_domain_rule(RegionEvaluator(disk(0, 0, 1)), grid(1.1, 5), options);
  EXPECT_EQ(rule.report().order_difference.volume, 0);
  EXPECT_EQ(rule.report().order_difference.boundary, 0);
}

TEST(AccuracyReport, CoversTheErrorsAtEveryPositionOfTheGrid) {
  // Turned and moved: the measures differ by less than what the report says, plus rounding.
  for (const StandardRegion& body : regions_of_known_measure()) {
    const int dimension = body.region.dimension();
    for (int k = 0; k < 20; ++k) {
      Box box = body.box;
      for (int axis = 0; axis < dimension; ++axis) {
        const double shift = 0.0137 * k * (axis == 1 ? -0.7 : 1) / (axis + 1);
        box.low[axis] += shift;
        box.high[axis] += shift + 0.003 * k;
      }
      const DomainRule rule = rule_for(body.region, Grid(box, {6, 6, 6}), 3);
      const QuadratureReport& report = rule.report();
      EXPECT_LE(std::fabs(rule.measure() - body.measure),
                report.order_difference.volume + report.uncertified.measure + 1e-13)
          << body.name << " " << k;
      EXPECT_LE(std::fabs(rule.boundary_measure() - body.boundary),
                report.order_difference.boundary + report.uncertified.measure + 1e-12)
          << body.name << " " << k;
    }
  }
}

TEST(AccuracyReport, SliversKeepHighPowersRelativeToThemselves) {
  // A strip that is w wide is all that a spline of degree 4 sees whose support ends at y = 1/2: the
  // integral of its square, ∫ (y − 1/2)⁸ over [0, 1] × [1/2, 1/2 + w], is tiny and must be right.
  for (const double w : {1e-2, 1e-4, 1e-6}) {
    const Region region = half_plane(1, 0, 0) & half_plane(-1, 0, 1) & half_plane(0, 1, 0) &
                          half_plane(0, -1, 0.5 + w);
    const DomainRule rule = rule_for(region, Grid({2, {0, 0}, {1, 1}}, {4, 4}), 5);
    const VolumePoints& points = rule.cut_points();
    double moment = 0;
    for (int i = 0; i < points.size(); ++i)
      if (const double y = points.coordinates[1][i] - 0.5; y > 0)
        moment += points.weights[i] * std::pow(y, 8);
    // The side of the strip is rounded to 1.1e-16.
    EXPECT_NEAR(moment / (std::pow(w, 9) / 9), 1, 1e-13 + 2e-15 / w) << w;
  }
}

}  // namespace
