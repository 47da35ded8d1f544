// Moved and turned against the grid, a body keeps its measure and its boundary to within what the
// reports of the two rules say.

#include <gmock/gmock.h>

#include <random>

#include "core/mapped_region.hpp"
#include "quadrature/domain_rule.hpp"
#include "tests/quadrature/standard_regions.hpp"

using namespace rfm;
using namespace rfm::test;

namespace {

constexpr int positions = 20;

struct Measured {
  CellMeasure value, error;
};

Measured measured(const StandardRegion& body, int cells, int points, const Similarity& position) {
  Box box = body.box;
  const Point center = box.center();
  const double half = 0.75 * box.longest_side();  // room for all rotations
  for (int axis = 0; axis < box.dimension; ++axis) {
    box.low[axis] = center[axis] - half;
    box.high[axis] = center[axis] + half;
  }
  QuadratureOptions options;
  options.inside_points = options.cut_points = points;
  const DomainRule rule = make_domain_rule(RegionEvaluator(transformed(body.region, position)),
                                           Grid(box, {cells, cells, cells}), options);
  const QuadratureReport& report = rule.report();
  const double boundary = rule.boundary_measure();
  constexpr double rounding = 1e-13;
  return {{rule.measure(), boundary},
          {report.order_difference.volume + report.uncertified.measure + rounding * boundary,
           report.order_difference.boundary + report.uncertified.boundary + rounding * boundary}};
}

void expect_positions_to_agree(const StandardRegion& body, int cells, int points, int count) {
  std::mt19937 generator(7);
  const auto uniform = [&] { return 0x1p-31 * generator() - 1; };
  Measured known;
  if (std::isnan(body.measure))
    known = measured(body, 2 * cells, points + 2, {});
  else
    known.value = {body.measure, body.boundary};
  double largest = 0, boundary = 0;
  for (int k = 0; k < count; ++k) {
    Similarity position;
    position.about = body.box.center();
    position.angle = std::numbers::pi * uniform();
    for (int axis = 0; axis < body.box.dimension; ++axis)
      position.translation[axis] = 0.05 * body.box.longest_side() * uniform();
    if (body.box.dimension == 3) position.axis = {uniform(), uniform(), uniform()};
    const Measured here = measured(body, cells, points, position);
    const double difference = std::fabs(here.value.volume - known.value.volume);
    const double other = std::fabs(here.value.boundary - known.value.boundary);
    EXPECT_LE(difference, here.error.volume + known.error.volume) << body << " " << k;
    EXPECT_LE(other, here.error.boundary + known.error.boundary) << body << " " << k;
    largest = std::max(largest, difference / here.error.volume);
    boundary = std::max(boundary, other / here.error.boundary);
  }
  std::printf("%s: %.2g of the reported error in volume, %.2g on the boundary\n", body.name,
              largest, boundary);
}

class Positions : public testing::TestWithParam<StandardRegion> {};
INSTANTIATE_TEST_SUITE_P(Plane, Positions, testing::ValuesIn(standard_regions_2d()));
INSTANTIATE_TEST_SUITE_P(Space, Positions, testing::ValuesIn(standard_regions_3d()));

TEST_P(Positions, ChangeMeasuresByLessThanTheReportedErrors) {
  if (GetParam().box.dimension == 2) {
    for (const int points : {2, 4, 6}) expect_positions_to_agree(GetParam(), 16, points, positions);
  } else {
    expect_positions_to_agree(GetParam(), 8, 3, 2);
  }
}

class LongPositions : public testing::TestWithParam<StandardRegion> {};
INSTANTIATE_TEST_SUITE_P(LongSpace, LongPositions, testing::ValuesIn(standard_regions_3d()));

TEST_P(LongPositions, ChangeMeasuresByLessThanTheReportedErrors) {
  for (const int cells : {8, 16})
    for (const int points : {2, 4}) expect_positions_to_agree(GetParam(), cells, points, positions);
}

}  // namespace
